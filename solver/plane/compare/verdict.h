// What is wrong with a matrix of view factors of a scene in the plane.
#pragma once

#include "solver/compare/verdict.h"

namespace hottel {

struct PreparedScene2;

// As judge() of solver/compare/verdict.h, of a scene in the plane.
//
// REQUIRES: both matrices are over the elements of `prepared`; the exact one has visibilities.
// COST: a few passes over both matrices; another exact matrix, of both sides of all edges, when something is off; and
// an exact sum for each pair that is off and exchanges nothing.
Verdict judge(const PreparedScene2& prepared, const ExchangeMatrix& exact, const ExchangeMatrix& matrix,
              const VerdictOptions& options, const VerdictWatch& watch = {});

}  // namespace hottel

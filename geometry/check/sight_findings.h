// What is worth telling about what faces see.
#pragma once

#include "geometry/check/finding.h"
#include "geometry/exchange/exchange_2.h"

namespace hottel {

// Kinds: not-closed (error), sees-only-black, sees-only-sky (a whole polyline, or an edge of its own).
// REQUIRES: the exact matrix of the scene, a row for each face.
Findings sight_findings(const Scene2& scene, const ExchangeMatrix& matrix);

}  // namespace hottel

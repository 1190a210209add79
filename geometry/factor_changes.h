// What a change of the scene did to its view factors.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "geometry/exchange_matrix.h"

namespace hottel {

// One view factor before and after: nothing where a face had no row then or was not there, 0 where the two were there
// but exchanged nothing.
struct FactorChange {
  std::string from, to;
  std::optional<double> before, after;
};

// Returns every pair whose factor, as a double, is not what it was: in the order of the first matrix, new faces last,
// by `from` and then by `to`. The sky counts as a face that has no row. Faces are matched by name: `former_name` says
// what an element of the second matrix was called in the first.
//
//   (1) a matrix and itself, with names that did not change, give no changes
//   (2) before != after in every change; one of them may be nothing
//
// REQUIRES: names are unique in each matrix.
// COST: O(n log n) for n entries of both.
std::vector<FactorChange> factor_changes(const ExchangeMatrix& before, const ExchangeMatrix& after,
                                         const std::function<std::string(const Element&)>& former_name);

}  // namespace hottel

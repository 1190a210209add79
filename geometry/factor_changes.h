// What a change of the scene did to its view factors.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "geometry/exchange_matrix.h"

namespace hottel {

// One view factor before and after; nothing where a face had no row then or was not there.
struct FactorChange {
  std::string from, to;
  std::optional<double> before, after;
};

// Returns every pair whose correctly rounded factor is not what it was, in the order of the first matrix, new faces
// last. Faces are matched by name: `former_name` says what an element of the second matrix was called in the first.
std::vector<FactorChange> factor_changes(const ExchangeMatrix& before, const ExchangeMatrix& after,
                                         const std::function<std::string(const Element&)>& former_name);

}  // namespace hottel

// Exact partial visibilities of all pairs of elements.
#pragma once

#include <algorithm>

#include "geometry/exchange/exchange_2.h"

namespace hottel {

class ExactVisibility2 {
 public:
  // COST: that of the exact factors.
  explicit ExactVisibility2(const PreparedScene2& prepared)
      : exact_(exact_exchange(prepared, {.per = Per::kElement})) {}

  // Vis(i, j) = S / S0, correctly rounded; 0 iff S = 0. REQUIRES that one of the two has a row.
  double of(std::uint32_t i, std::uint32_t j) const {
    const std::uint32_t from = exact_.has_row(i) ? i : j, to = from == i ? j : i;
    const auto row = exact_.row(from);
    const auto entry = std::lower_bound(row.begin(), row.end(), to,
                                        [](const FactorEntry& e, std::uint32_t column) { return e.to < column; });
    return entry != row.end() && entry->to == to ? entry->visibility : 0;
  }

 private:
  ExchangeMatrix exact_;
};

}  // namespace hottel

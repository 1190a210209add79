// Exact partial visibilities of all pairs of elements.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/exchange_matrix.h"

namespace hottel {

// The exact Vis(i, j) of all pairs of elements, for methods that approximate only the rest of a factor.
//
//   (1) of(i, j) == of(j, i); it is 0 iff nothing of one sees anything of the other, decided without rounding
//   (2) black backs, which have no row, are found by those that see them
// Many threads may ask at once. The scene is not needed afterwards.
class ExactVisibility {
 public:
  // REQUIRES exact factors by elements, with visibilities.
  explicit ExactVisibility(ExchangeMatrix exact) : exact_(std::move(exact)), rows_that_see_(exact_.size()) {
    for (std::uint32_t i = 0; i < exact_.size(); ++i)
      for (const FactorEntry& entry : exact_.row(i))
        if (entry.to != exact_.sky() && !exact_.has_row(entry.to)) rows_that_see_[entry.to].push_back(i);
  }

  // Appends the elements j with S(i, j) > 0, where one of i and j at least has a row; no others, and not the sky. COST:
  // the number of these.
  void append_partners(std::uint32_t i, std::vector<std::uint32_t>& elements) const {
    for (const FactorEntry& entry : exact_.row(i))
      if (entry.to != exact_.sky()) elements.push_back(entry.to);
    elements.insert(elements.end(), rows_that_see_[i].begin(), rows_that_see_[i].end());
  }

  // Vis(i, j) = S / S0 as the matrix has it; 0 iff S = 0. REQUIRES that one of the two has a row.
  double of(std::uint32_t i, std::uint32_t j) const {
    const std::uint32_t from = exact_.has_row(i) ? i : j, to = from == i ? j : i;
    const auto entry = exact_.row(from).find(to);
    return entry ? entry->visibility : 0;
  }

 private:
  ExchangeMatrix exact_;
  std::vector<std::vector<std::uint32_t>> rows_that_see_;  // by element without a row
};

}  // namespace hottel

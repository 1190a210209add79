// Elements that stand for all of them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/exchange_matrix.h"

namespace hottel {

// An element, and the area that it stands for.
struct SampledElement {
  std::uint32_t element = 0;
  double weight = 0;
  friend bool operator==(const SampledElement&, const SampledElement&) = default;
};

// Returns elements with a row that stand for all: a sum over them, by weight, is one over all by their areas.
// importance: of each element, what a value there is at most, or about.
//
//   (1) all of them, by their areas, where they are no more than `most`
//   (2) else those in which `most` places lie, one drawn from each of as many equal parts of area times importance,
//       taken in the order of the elements. The sum is then right on average, whatever it is of, but for elements of no
//       importance, which are left out; and it is off the less the nearer importance is to the value
//   (3) ascending; the same for the same matrix, on any machine
// REQUIRES importances that are numbers, not below 0.
std::vector<SampledElement> sampled_elements(const ExchangeMatrix& matrix, std::span<const double> importance,
                                             std::uint32_t most);

}  // namespace hottel

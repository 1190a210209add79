#include "geometry/row_cuts.h"

#include <algorithm>

namespace hottel {

RowCuts::RowCuts(std::uint32_t rows, std::size_t ranges) {
  const std::size_t count = std::clamp<std::size_t>(ranges, 1, std::max<std::size_t>(rows, 1));
  for (std::size_t k = 1; k <= count; ++k) ends_.push_back(static_cast<std::uint32_t>(rows * k / count));
}

std::size_t RowCuts::of(std::uint32_t row) const {
  return static_cast<std::size_t>(std::ranges::upper_bound(ends_, row) - ends_.begin());
}

}  // namespace hottel

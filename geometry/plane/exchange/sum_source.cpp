#include "geometry/plane/exchange/sum_source.h"

#include <algorithm>
#include <span>
#include <utility>

#include "kernel/support/parallel.h"

namespace hottel {

SumsInMemory2::SumsInMemory2(PairSums2 sums, std::size_t entries_in_range)
    : sums_(std::move(sums)), cuts_(sums_.rows(), 2 * sums_.size() / entries_in_range + 1) {}

std::vector<PairSum2> SumsInMemory2::sums(std::size_t k) const {
  const RowRange range = cuts_.range(k);
  // Of rows before the range the pairs with its rows, of those in it all.
  std::vector<std::span<const PairSum2>> parts(range.end);
  parallel_for(
      range.end,
      [&](std::size_t i) {
        const std::span<const PairSum2> row = sums_.row(static_cast<std::uint32_t>(i));
        const auto from = [&](std::uint32_t label) { return std::ranges::lower_bound(row, label, {}, &PairSum2::j); };
        parts[i] = i < range.first ? std::span(from(range.first), from(range.end)) : row;
      },
      256);
  std::vector<PairSum2> result;
  std::size_t size = 0;
  for (const auto& part : parts) size += part.size();
  result.reserve(size);
  for (const auto& part : parts) result.insert(result.end(), part.begin(), part.end());
  return result;
}

}  // namespace hottel

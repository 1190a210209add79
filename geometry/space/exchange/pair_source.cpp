#include "geometry/space/exchange/pair_source.h"

#include <algorithm>
#include <utility>

namespace hottel {

PairsInMemory3::PairsInMemory3(std::uint32_t rows, std::size_t entries_in_range)
    : rows_(rows), entries_in_range_(entries_in_range), cuts_(rows, 1) {}

void PairsInMemory3::keep(std::span<const PairSum3> pairs) {
  pairs_.insert(pairs_.end(), pairs.begin(), pairs.end());
  begins_.clear();
}

void PairsInMemory3::sort() {
  if (!begins_.empty()) return;
  std::ranges::sort(pairs_, {}, [](const PairSum3& pair) { return std::pair(pair.i, pair.j); });
  begins_.assign(rows_ + std::size_t{1}, 0);
  for (const PairSum3& pair : pairs_) ++begins_[pair.i + std::size_t{1}];
  for (std::size_t row = 1; row < begins_.size(); ++row) begins_[row] += begins_[row - 1];
  cuts_ = RowCuts(rows_, 2 * pairs_.size() / entries_in_range_ + 1);
}

const RowCuts& PairsInMemory3::cuts() {
  sort();
  return cuts_;
}

std::vector<PairSum3> PairsInMemory3::pairs(std::size_t k) {
  sort();
  const RowRange range = cuts_.range(k);
  const auto place = [this](std::size_t number) { return pairs_.begin() + static_cast<std::ptrdiff_t>(number); };
  std::vector<PairSum3> result;
  for (std::uint32_t i = 0; i < range.first; ++i) {
    const auto end = place(begins_[i + std::size_t{1}]);
    auto pair = std::ranges::lower_bound(place(begins_[i]), end, range.first, {}, &PairSum3::j);
    for (; pair != end && range.has(pair->j); ++pair) result.push_back(*pair);
  }
  result.insert(result.end(), place(begins_[range.first]), place(begins_[range.end]));
  return result;
}

}  // namespace hottel

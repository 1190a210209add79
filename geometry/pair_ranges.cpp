#include "geometry/pair_ranges.h"

#include <algorithm>

#include "kernel/support/failure.h"

namespace hottel {

bool PairRanges::has(std::uint32_t i, std::uint32_t j) const {
  const std::vector<ColumnRange>& row = rows_[i];
  const auto after =
      std::upper_bound(row.begin(), row.end(), j, [](std::uint32_t c, const ColumnRange& r) { return c < r.begin; });
  return after != row.begin() && j < std::prev(after)->end;
}

void PairRanges::add(std::uint32_t i, ColumnRange columns) {
  HOTTEL_REQUIRE(i < elements_ && i <= columns.begin && columns.begin < columns.end && columns.end <= elements_ + 1);
  std::vector<ColumnRange>& row = rows_[i];
  // All that meet or touch it become one.
  const auto first = std::find_if(row.begin(), row.end(), [&](const ColumnRange& r) { return r.end >= columns.begin; });
  auto last = first;
  for (; last != row.end() && last->begin <= columns.end; ++last) {
    columns.begin = std::min(columns.begin, last->begin);
    columns.end = std::max(columns.end, last->end);
  }
  row.insert(row.erase(first, last), columns);
}

std::vector<ColumnRange> PairRanges::missing(std::uint32_t i) const {
  std::vector<ColumnRange> result;
  std::uint32_t begin = i;
  for (const ColumnRange& known : rows_[i]) {
    if (begin < known.begin) result.push_back({begin, known.begin});
    begin = known.end;
  }
  if (begin <= elements_) result.push_back({begin, elements_ + 1});
  return result;
}

bool PairRanges::has_all() const {
  for (std::uint32_t i = 0; i < elements_; ++i)
    if (rows_[i].size() != 1 || rows_[i][0] != ColumnRange{i, elements_ + 1}) return false;
  return true;
}

}  // namespace hottel

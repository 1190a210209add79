#include "geometry/plane/exchange/pair_sums.h"

#include <utility>

#include "kernel/support/parallel.h"

namespace hottel {

PairSums2::PairSums2(std::vector<std::vector<PairSum2>> parts, std::uint32_t rows)
    : parts_(std::move(parts)), rows_(rows), before_(rows + std::size_t{1}, 0) {
  parallel_for(parts_.size(), [this](std::size_t part) {
    const std::span<const PairSum2> sums(parts_[part]);
    for (std::size_t begin = 0, end = 0; begin < sums.size(); begin = end) {
      const std::uint32_t i = sums[begin].i();
      while (end < sums.size() && sums[end].i() == i) ++end;
      rows_[i] = sums.subspan(begin, end - begin);
    }
  });
  for (std::uint32_t i = 0; i < rows; ++i) before_[i + 1] = before_[i] + rows_[i].size();
}

EntryPlaces2::EntryPlaces2(const PairSums2& sums, const ElementTable2& table)
    : sums_(sums), begin_(table.count() + std::size_t{1}, 0), back_entries_(table.count(), 0), back_(sums.size()) {
  std::size_t k = 0;
  sums.for_each([&](const PairSum2& sum) {
    const std::uint32_t j = sum.j();
    if (j != sum.i() && table.has_row(j)) back_[k] = back_entries_[j]++;
    ++k;
  });
  for (std::uint32_t i = 0; i < table.count(); ++i)
    begin_[i + 1] = begin_[i] + back_entries_[i] + (table.has_row(i) ? sums.row(i).size() : 0);
}

}  // namespace hottel

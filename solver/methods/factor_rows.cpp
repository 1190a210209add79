#include "solver/methods/factor_rows.h"

#include <algorithm>
#include <limits>

#include "kernel/support/interrupt.h"
#include "kernel/support/parallel.h"
#include "kernel/support/progress_count.h"

namespace hottel {

ExchangeMatrix matrix_of_rows(const std::vector<Element>& elements, const std::vector<std::vector<FactorEntry>>& rows) {
  std::vector<std::size_t> begin{0};
  FactorEntries entries;
  for (const auto& row : rows) {
    entries.append(row);
    begin.push_back(entries.size());
  }
  ExchangeMatrix matrix(elements, Guarantee::kEstimated);
  matrix.assign(std::move(begin), std::move(entries));
  return matrix;
}

std::vector<FactorEntry> RowSums::take() {
  std::sort(touched_.begin(), touched_.end());
  std::vector<FactorEntry> row;
  for (const std::uint32_t column : touched_) {
    row.push_back({column, {sums_[column], 0}, std::numeric_limits<double>::quiet_NaN()});
    sums_[column] = 0;
  }
  touched_.clear();
  return row;
}

ExchangeMatrix matrix_by_rows(const std::vector<Element>& elements,
                              const std::function<bool(std::uint32_t element)>& wants_row,
                              const std::function<void(double)>& progress, const std::function<FillRow()>& make_fill) {
  const std::size_t n = elements.size();
  std::vector<std::vector<FactorEntry>> rows(n);
  ProgressCount done(progress, n);
  parallel_ranges(n, 1, [&](std::size_t first, std::size_t last) {
    const FillRow fill = make_fill();
    RowSums by(n + 1);
    for (std::size_t from = first; from != last; ++from) {
      throw_if_interrupted();
      done.add();
      const auto i = static_cast<std::uint32_t>(from);
      if (!wants_row(i)) continue;
      fill(i, by);
      rows[i] = by.take();
    }
  });
  return matrix_of_rows(elements, rows);
}

}  // namespace hottel

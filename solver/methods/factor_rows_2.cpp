#include "solver/methods/factor_rows_2.h"

#include <limits>

#include "kernel/interrupt.h"
#include "kernel/parallel.h"

namespace hottel {

ExchangeMatrix matrix_of_rows(const ElementGeometry2& geometry, const std::vector<std::vector<FactorEntry>>& rows) {
  std::vector<std::size_t> begin{0};
  std::vector<FactorEntry> entries;
  for (const auto& row : rows) {
    entries.insert(entries.end(), row.begin(), row.end());
    begin.push_back(entries.size());
  }
  ExchangeMatrix matrix(geometry.labels().elements(), Guarantee::kEstimated);
  matrix.assign(std::move(begin), std::move(entries));
  return matrix;
}

ExchangeMatrix matrix_by_rows(const ElementGeometry2& geometry, const FillRow& fill) {
  const std::uint32_t n = geometry.count();
  std::vector<std::vector<FactorEntry>> rows(n);
  parallel_ranges(n, 1, [&](std::size_t first, std::size_t last) {
    std::vector<double> by;
    for (std::size_t from = first; from != last; ++from) {
      throw_if_interrupted();
      const auto i = static_cast<std::uint32_t>(from);
      if (!geometry.has_row(i) || geometry.runs(i).empty()) continue;
      by.assign(n + std::size_t{1}, 0);
      fill(i, by);
      for (std::uint32_t j = 0; j <= n; ++j)
        if (by[j] != 0) rows[i].push_back({j, {by[j], 0}, std::numeric_limits<double>::quiet_NaN()});
    }
  });
  return matrix_of_rows(geometry, rows);
}

}  // namespace hottel

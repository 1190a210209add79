#include "solver/methods/pair_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/support/interrupt.h"
#include "kernel/support/parallel.h"
#include "kernel/support/progress_count.h"
#include "solver/methods/factor_rows.h"

namespace hottel {
namespace {

constexpr double kNotAsked = std::numeric_limits<double>::quiet_NaN();

struct LaterFactors {
  std::uint32_t to;  // > from
  PairFactors factors;
};

// Gives what the other factors leave of 1 to the sky, where the row ends; returns the row's defect.
double close_row(std::vector<FactorEntry>& row, std::uint32_t sky, bool borders_open_space) {
  double sum = 0;
  for (const FactorEntry& entry : row) sum += entry.factor.value;
  if (borders_open_space && sum < 1) {
    row.push_back({sky, {1 - sum, 0}, kNotAsked});
    sum += 1 - sum;
  }
  return std::fabs(sum - 1);
}

}  // namespace

ExchangeMatrix matrix_of_pairs(const PairRows& of, const PairsOfElements& pairs,
                               const std::function<void(double)>& progress, MethodReport& report) {
  const auto n = static_cast<std::uint32_t>(of.elements.size());
  std::vector<std::vector<LaterFactors>> later(n);
  ProgressCount done(progress, n);
  parallel_for(n, [&](std::size_t row) {
    throw_if_interrupted();
    const auto i = static_cast<std::uint32_t>(row);
    std::vector<std::uint32_t> partners;
    pairs.append_partners(i, partners);
    std::sort(partners.begin(), partners.end());
    partners.erase(std::unique(partners.begin(), partners.end()), partners.end());
    for (const std::uint32_t j : partners) {
      if (j <= i || !(of.has_row(i) || of.has_row(j))) continue;
      const PairFactors both = pairs.factors(i, j);
      if (both.forth > 0 || both.back > 0) later[i].push_back({j, both});
    }
    done.add();
  });

  std::vector<std::vector<FactorEntry>> rows(n);
  const auto add = [&](std::uint32_t from, std::uint32_t to, double factor) {
    if (factor > 0 && of.has_row(from)) rows[from].push_back({to, {factor, 0}, kNotAsked});
  };
  for (std::uint32_t i = 0; i < n; ++i)
    for (const LaterFactors& pair : later[i]) {
      add(i, pair.to, pair.factors.forth);
      add(pair.to, i, pair.factors.back);
    }
  for (std::uint32_t i = 0; i < n; ++i)
    if (of.has_row(i)) report.row_defect = std::max(report.row_defect, close_row(rows[i], n, of.is_open[i] != 0));
  return matrix_of_rows(of.elements, rows);
}

}  // namespace hottel

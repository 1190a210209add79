#include "solver/normalised_method.h"

#include <algorithm>
#include <span>

#include "solver/radiosity/double_double_ball.h"

namespace hottel {
namespace {

void normalise(std::span<FactorEntry> row) {
  double total = 0;
  for (const FactorEntry& entry : row) total += entry.factor.value;
  if (!(total > 0)) return;
  for (FactorEntry& entry : row) entry.factor = {entry.factor.value / total, 0};
  Rounded& largest = std::max_element(row.begin(), row.end(), [](const FactorEntry& a, const FactorEntry& b) {
                       return a.factor.value < b.factor.value;
                     })->factor;
  DoubleDoubleBall rest{1, 0, 0};
  for (const FactorEntry& entry : row)
    if (&entry.factor != &largest) rest = difference(rest, {entry.factor.value, 0, 0});
  largest.value = rest.lo < 0 ? std::nextafter(rest.hi, 0) : rest.hi;
}

}  // namespace

ExchangeMatrix normalised(const ExchangeMatrix& matrix) {
  std::vector<std::size_t> begin(matrix.size() + 1, 0);
  FactorEntries entries;
  entries.reserve(matrix.entry_count());
  std::vector<FactorEntry> row;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    row.assign(matrix.row(i).begin(), matrix.row(i).end());
    normalise(row);
    entries.append(row);
    begin[i + 1] = entries.size();
  }
  ExchangeMatrix result(matrix.elements(), Guarantee::kEstimated);
  result.assign(std::move(begin), std::move(entries));
  return result;
}

double error_after_division(double error, double row_error) {
  return row_error < 1 ? (error + row_error) / (1 - row_error) : std::numeric_limits<double>::infinity();
}

}  // namespace hottel

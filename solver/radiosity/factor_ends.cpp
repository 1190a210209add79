#include "solver/radiosity/factor_ends.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "solver/radiosity/radiosity_system.h"

namespace hottel {

ExchangeMatrix matrix_of_ends(const ExchangeMatrix& matrix, double Enclosure::*end) {
  std::vector<std::size_t> begin{0};
  FactorEntries entries;
  entries.reserve(matrix.entry_count());
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    for (std::size_t k = 0; k < matrix.row(i).size(); ++k) {
      FactorEntry entry = matrix.row(i)[k];
      entry.factor = {matrix.bounds(i, k).*end, 0};
      entries.push_back(entry);
    }
    begin.push_back(entries.size());
  }
  ExchangeMatrix result(matrix.elements(), Guarantee::kEstimated);
  result.assign(std::move(begin), std::move(entries));
  return result;
}

bool has_closed_enclosures(const ExchangeMatrix& matrix) {
  if (matrix.guarantee() != Guarantee::kEnclosed || !matrix.has_closed_rows()) return false;
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    for (std::size_t k = 0; k < matrix.row(i).size(); ++k)
      if (!is_positive(matrix.row(i)[k].factor) && matrix.bounds(i, k).upper > 0) return false;
  return true;
}

}  // namespace hottel

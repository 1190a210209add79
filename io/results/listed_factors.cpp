#include "io/results/listed_factors.h"

#include "geometry/scene_names.h"
#include "io/results/csv_field.h"

namespace hottel {

std::vector<std::string> csv_names(const ExchangeMatrix& matrix) {
  std::vector<std::string> names;
  for (std::uint32_t i = 0; i <= matrix.size(); ++i) names.push_back(csv_field(matrix.name(i)));
  return names;
}

std::vector<std::uint64_t> listed_counts(const FactorTable& table) {
  std::vector<std::uint64_t> counts(table.matrix.size(), 0);
  if (table.ranges != nullptr && table.only_columns.empty()) {
    const auto begins = table.ranges->begins();
    for (std::uint32_t i = 0; i < counts.size(); ++i)
      if (is_asked(table.only_rows, i)) counts[i] = begins[i + std::size_t{1}] - begins[i];
    return counts;
  }
  for_each_listed(table, [&](std::uint32_t from, const FactorEntry&, const Enclosure&, Guarantee) { ++counts[from]; });
  return counts;
}

std::string area_of(const ExchangeMatrix& matrix, std::uint32_t label) {
  return "the area of '" + matrix.name(label) + "'";
}

}  // namespace hottel

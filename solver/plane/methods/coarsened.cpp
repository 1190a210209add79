#include "solver/plane/methods/coarsened.h"

#include <limits>
#include <map>

namespace hottel {
namespace {

// The label of each element, and of the sky, among those of faces or groups.
std::vector<std::uint32_t> table_of(const ExchangeMatrix& matrix, const ElementTable2& table, const Scene2& scene,
                                    Granularity granularity) {
  const auto key = [&](const Element& element) {
    return std::pair(granularity == Granularity::kGroup ? scene.surfaces[element.surface].group : element.surface,
                     element.is_back);
  };
  std::map<std::pair<std::uint32_t, bool>, std::uint32_t> place;
  for (std::uint32_t label = 0; label < table.count(); ++label) place[key(table.elements()[label])] = label;
  std::vector<std::uint32_t> result;
  for (const Element& element : matrix.elements()) result.push_back(place.at(key(element)));
  result.push_back(table.sky());
  return result;
}

}  // namespace

ExchangeMatrix coarsened(const ExchangeMatrix& matrix, const PreparedScene2& prepared, Granularity granularity) {
  const PreparedScene2 whole = prepare(prepared.scene, Divided2::kNo);
  const ElementTable2 table(whole.scene, whole.arrangement, whole.division, granularity);
  const std::vector<std::uint32_t> label_of = table_of(matrix, table, prepared.scene, granularity);
  std::vector<std::map<std::uint32_t, double>> rows(table.count());
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    for (const FactorEntry& entry : matrix.row(i))
      rows[label_of[i]][label_of[entry.to]] += matrix.elements()[i].area.value * entry.factor.value;
  std::vector<std::size_t> begin(1, 0);
  std::vector<FactorEntry> entries;
  for (std::uint32_t label = 0; label < table.count(); ++label) {
    for (const auto& [to, exchange] : rows[label])
      entries.push_back(
          {to, {exchange / table.elements()[label].area.value, 0}, std::numeric_limits<double>::quiet_NaN()});
    begin.push_back(entries.size());
  }
  ExchangeMatrix result(table.elements(), Guarantee::kEstimated);
  result.assign(std::move(begin), std::move(entries));
  return result;
}

}  // namespace hottel

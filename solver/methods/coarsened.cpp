#include "solver/methods/coarsened.h"

#include <limits>
#include <map>

namespace hottel {
namespace {

// The label of each element, and of the sky, among those of faces or groups.
std::vector<std::uint32_t> labels_of(const ExchangeMatrix& matrix, const SceneTable& scene,
                                     const std::vector<Element>& whole, Granularity granularity) {
  const auto key = [&](const Element& element) {
    return std::pair(granularity == Granularity::kGroup ? scene.surfaces[element.surface].group : element.surface,
                     element.is_back);
  };
  std::map<std::pair<std::uint32_t, bool>, std::uint32_t> place;
  const auto count = static_cast<std::uint32_t>(whole.size());
  for (std::uint32_t label = 0; label < count; ++label) place[key(whole[label])] = label;
  std::vector<std::uint32_t> result;
  for (const Element& element : matrix.elements()) result.push_back(place.at(key(element)));
  result.push_back(count);
  return result;
}

}  // namespace

ExchangeMatrix coarsened(const ExchangeMatrix& matrix, const SceneTable& scene, const std::vector<Element>& whole,
                         Granularity granularity) {
  const std::vector<std::uint32_t> label_of = labels_of(matrix, scene, whole, granularity);
  std::vector<std::map<std::uint32_t, double>> rows(whole.size());
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    for (const FactorEntry& entry : matrix.row(i))
      rows[label_of[i]][label_of[entry.to]] += matrix.elements()[i].area.value * entry.factor.value;
  std::vector<std::size_t> begin(1, 0);
  std::vector<FactorEntry> entries;
  for (std::size_t label = 0; label < whole.size(); ++label) {
    for (const auto& [to, exchange] : rows[label])
      entries.push_back({to, {exchange / whole[label].area.value, 0}, std::numeric_limits<double>::quiet_NaN()});
    begin.push_back(entries.size());
  }
  ExchangeMatrix result(whole, Guarantee::kEstimated);
  result.assign(std::move(begin), std::move(entries));
  return result;
}

}  // namespace hottel

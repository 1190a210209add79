#include "solver/methods/coarsened.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "solver/methods/factor_rows.h"

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

ExchangeMatrix merged_matrix(const ExchangeMatrix& matrix, std::span<const std::uint32_t> label_of,
                             std::vector<Element> whole) {
  HOTTEL_REQUIRE(label_of.size() == matrix.size() + std::size_t{1} && label_of.back() == whole.size());
  std::vector<std::vector<std::uint32_t>> members(whole.size());
  for (std::uint32_t i = 0; i < matrix.size(); ++i) members[label_of[i]].push_back(i);
  std::vector<std::vector<FactorEntry>> rows(whole.size());
  parallel_ranges(whole.size(), 8, [&](std::size_t from, std::size_t to) {
    std::vector<double> exchange(whole.size() + 1, 0);
    std::vector<bool> is_met(whole.size() + 1, false);
    std::vector<std::uint32_t> met;
    for (std::size_t label = from; label < to; ++label) {
      for (const std::uint32_t i : members[label])
        for (const FactorEntry& entry : matrix.row(i)) {
          const std::uint32_t column = label_of[entry.to];
          if (!is_met[column]) met.push_back(column);
          is_met[column] = true;
          exchange[column] += matrix.elements()[i].area.value * entry.factor.value;
        }
      std::ranges::sort(met);
      for (const std::uint32_t column : met) {
        rows[label].push_back(
            {column, {exchange[column] / whole[label].area.value, 0}, std::numeric_limits<double>::quiet_NaN()});
        exchange[column] = 0;
        is_met[column] = false;
      }
      met.clear();
    }
  });
  return matrix_of_rows(whole, rows);
}

ExchangeMatrix coarsened(const ExchangeMatrix& matrix, const SceneTable& scene, const std::vector<Element>& whole,
                         Granularity granularity) {
  return merged_matrix(matrix, labels_of(matrix, scene, whole, granularity), whole);
}

}  // namespace hottel

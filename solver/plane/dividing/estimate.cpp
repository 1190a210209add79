#include "solver/plane/dividing/estimate.h"

#include <limits>
#include <utility>

#include "geometry/plane/exchange/chosen_rows.h"
#include "geometry/plane/exchange/exchange_sums.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "solver/dividing/cut_elements.h"
#include "solver/dividing/direct_parts.h"
#include "solver/dividing/merged_elements.h"
#include "solver/dividing/sampled_elements.h"
#include "solver/plane/light/tested_shares.h"
#include "solver/refinement.h"

namespace hottel {
namespace {

std::vector<TreeNode> halves_of(const Element& element) {
  return {{element.part, element.path.child(0)}, {element.part, element.path.child(1)}};
}

// What the halves of each sample gather.
std::vector<std::vector<PartSight>> sights_of(const DividingRequest2& request,
                                              std::span<const SampledElement> samples) {
  const auto& [scene, matrix, solution, lights] = request.solved;
  const PreparedScene2 cut = prepare_divided(
      request.whole, with_trees(request.whole.scene, trees_with_parts(scene, matrix.elements(), samples, halves_of)));
  ElementTable2 table = *cut.elements(Granularity::kElement);
  const std::vector<std::uint32_t> around = elements_around(table.elements(), matrix.elements());
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> sample_of(matrix.size(), kNone);
  for (std::uint32_t k = 0; k < samples.size(); ++k) sample_of[samples[k].element] = k;
  std::vector<bool> is_half(table.count());
  for (std::uint32_t label = 0; label < table.count(); ++label) is_half[label] = sample_of[around[label]] != kNone;
  table.keep_rows(is_half);
  const std::uint64_t most_pairs =
      request.memory > 0 ? request.memory / kBytesPerPair : std::numeric_limits<std::uint64_t>::max();
  const std::vector<PlainRow2> rows = chosen_rows(cut, table, most_pairs, request.progress);
  const DirectParts direct(
      cut.scene, table.elements(),
      cut.scene.lights.empty() ? std::vector<LightShares>() : light_shares(cut, Granularity::kElement, request.lights));
  std::vector<std::vector<PartSight>> sights(samples.size());
  for (std::uint32_t label = 0; label < table.count(); ++label) {
    if (!is_half[label] || !table.has_row(label)) continue;
    PartSight half{.share = table.elements()[label].area.value, .irradiance = {}};
    for (std::size_t c = 0; c < solution.channels.size(); ++c) {
      double irradiance = direct.of(label, c);
      for (const auto& [column, factor] : rows[label])
        irradiance += factor * (column == table.sky()    ? to_double(scene.sky_emission.value[c])
                                : column < table.count() ? solution.channels[c].elements[around[column]].radiosity
                                                         : 0);
      half.irradiance.push_back(irradiance);
    }
    sights[sample_of[around[label]]].push_back(std::move(half));
  }
  return sights;
}

}  // namespace

ElementMerging merging_in_pairs(const Scene2& scene, std::span<const Element> elements) {
  return merged_elements(scene, elements, [](const Element& element) {
    return CoarsePart{element.part / 2, element.parts / 2};
  });
}

DividingEstimate estimate_dividing(const DividingRequest2& request) {
  SightsOfParts sights;
  if (request.has_exact_factors)
    sights = [&request](std::span<const SampledElement> samples) { return sights_of(request, samples); };
  return estimate_dividing(request.solved, request.most, sights, [&request] {
    return merging_in_pairs(request.whole.scene, request.solved.matrix.elements());
  });
}

}  // namespace hottel

#include "io/results/temperature_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <unordered_map>
#include <utility>

#include "geometry/face.h"
#include "geometry/scene_names.h"
#include "io/results/csv_field.h"
#include "io/results/short_digits.h"
#include "kernel/support/failure.h"
#include "solver/radiosity/element_temperatures.h"

namespace hottel {

bool has_temperatures(const SceneTable& scene) {
  const ElementTemperatures temperatures(scene.materials);
  const auto is_known = [&](std::optional<std::uint32_t> material) {
    return material && temperatures.is_known(*material);
  };
  return std::any_of(scene.surfaces.begin(), scene.surfaces.end(), [&](const Surface& surface) {
    return is_known(surface.material_of(false)) || is_known(surface.material_of(true));
  });
}

void write_temperature_csv(const SceneTable& scene, const ExchangeMatrix& matrix, const RadiositySolution& solution,
                           const std::function<void(std::string_view)>& sink, std::optional<int> digits) {
  for (const ChannelSolution& channel : solution.channels) HOTTEL_REQUIRE(channel.elements.size() == matrix.size());
  const ElementTemperatures temperatures(scene.materials);
  sink("face,element,channel,temperature,lower,upper\n");
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    const Element& element = matrix.elements()[i];
    const std::string face = csv_field(face_name(scene, {element.surface, element.is_back}));
    for (std::size_t c = 0; c < solution.channels.size(); ++c) {
      const auto found = temperatures.of(*element.material, solution, c, i);
      if (!found) continue;
      sink(fmt::format("{},{},{},{},{},{}\n", face, element.node().text(), solution.channel_names[c],
                       short_digits(found->value, digits), short_digits(found->lower, digits, RoundedTo::kBelow),
                       short_digits(found->upper, digits, RoundedTo::kAbove)));
    }
  }
}

namespace {

std::vector<FoundTemperatures> groups_of(const SceneTable& scene, const ExchangeMatrix& matrix,
                                         const RadiositySolution& solution, bool (*is_wanted)(const Material&)) {
  for (const ChannelSolution& channel : solution.channels) HOTTEL_REQUIRE(channel.elements.size() == matrix.size());
  const ElementTemperatures temperatures(scene.materials);
  std::vector<FoundTemperatures> result;
  std::unordered_map<std::string, std::size_t> place_of;  // of a name, the first of its channels
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    const Element& element = matrix.elements()[i];
    if (!is_wanted(scene.materials[*element.material])) continue;
    std::string name = side_text({scene.groups[scene.surfaces[element.surface].group].name, element.is_back});
    const auto [known, is_new] = place_of.emplace(std::move(name), result.size());
    const std::size_t first = solution.channels.size() == 2 ? kThermalBand : 0;
    for (std::size_t c = first; c < solution.channels.size(); ++c) {
      const BoundedTemperature t = temperatures.of(*element.material, solution, c, i)
                                       .value_or(BoundedTemperature{0, 0, std::numeric_limits<double>::infinity()});
      if (is_new) {
        result.push_back({known->first, solution.channel_names[c], t.value, t.value, t.lower, t.upper});
        continue;
      }
      FoundTemperatures& group = result[known->second + c - first];
      group.coldest = std::min(group.coldest, t.value);
      group.warmest = std::max(group.warmest, t.value);
      group.lower = std::min(group.lower, t.lower);
      group.upper = std::max(group.upper, t.upper);
    }
  }
  return result;
}

}  // namespace

std::vector<FoundTemperatures> insulated_groups(const SceneTable& scene, const ExchangeMatrix& matrix,
                                                const RadiositySolution& solution) {
  return groups_of(scene, matrix, solution, [](const Material& material) { return material.is_insulated(); });
}

std::vector<FoundTemperatures> given_flux_groups(const SceneTable& scene, const ExchangeMatrix& matrix,
                                                 const RadiositySolution& solution) {
  return groups_of(scene, matrix, solution,
                   [](const Material& material) { return material.has_given_flux() && !material.is_insulated(); });
}

}  // namespace hottel

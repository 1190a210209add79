#include "solver/plane/light/solved_light.h"

#include <algorithm>
#include <array>

#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "kernel/support/failure.h"
#include "solver/plane/light/average_illumination.h"
#include "solver/plane/light/free_parts.h"

namespace hottel {
namespace {

constexpr std::array kKinds{LightKind2::kPoint, LightKind2::kAverage, LightKind2::kInverseSquare};

}  // namespace

const char* to_string(LightKind2 kind) {
  constexpr std::array words{"point", "average", "inverse-square"};
  return words[static_cast<std::size_t>(kind)];
}

std::optional<LightKind2> light_kind_2(std::string_view word) {
  for (const LightKind2 kind : kKinds)
    if (word == to_string(kind)) return kind;
  return std::nullopt;
}

SolvedLight2 illuminate(LightKind2 kind, const PreparedScene2& prepared, const Grid2& grid, Granularity granularity,
                        const RadiositySolution& solution, const std::function<void(double)>& progress) {
  if (kind != LightKind2::kPoint && !prepared.scene.lights.empty())
    throw RequestError(std::string("light by \"") + to_string(kind) +
                       "\" does not know the scene's lights; \"point\" does");
  if (kind == LightKind2::kPoint)
    return {with_lights(prepared, illuminate_points(prepared, granularity, solution, grid, progress))};
  const auto channels = static_cast<std::uint32_t>(solution.channels.size());
  const std::vector<double> by_element = radiosity_by_element_2(solution);
  std::vector<double> sky = sky_by_channel_2(prepared.scene.sky_emission, channels);
  const ElementTable2& table = *prepared.elements(granularity);
  if (kind == LightKind2::kInverseSquare)
    return {illuminate_inverse_square(prepared, grid, table, by_element, channels, progress)};
  // From where there is light nobody sees the sky then; but what lies outside is in the cells too.
  if (!FreeParts2(prepared).has_outside()) std::ranges::fill(sky, 0.0);
  const FaceRadiosity2 faces(prepared.arrangement, table, by_element, sky);
  AverageIllumination2 averages = illuminate_averages(prepared, grid, faces, progress);
  return {std::move(averages.grid), averages.max_error};
}

}  // namespace hottel

#include "solver/plane/light/solved_light.h"

#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/visibility/visibility_polygon.h"
#include "kernel/support/failure.h"
#include "solver/plane/light/average_illumination.h"
#include "solver/plane/light/mean_irradiance.h"
#include "solver/radiosity/matrix_checks.h"

namespace hottel {

SolvedLight2 illuminate(std::string_view way, const PreparedScene2& prepared, const Grid2& grid,
                        Granularity granularity, const RadiositySolution& solution,
                        const std::function<void(double)>& progress) {
  const auto channels = static_cast<std::uint32_t>(solution.channels.size());
  const std::vector<double> by_element = radiosity_by_element_2(solution);
  const std::vector<double> sky = sky_by_channel_2(prepared.scene.sky_emission, channels);
  const ElementTable2 table(prepared.scene, prepared.arrangement, prepared.division, granularity);
  if (way == "inverse-square")
    return {illuminate_inverse_square(prepared, grid, table, by_element, channels, progress)};
  const FaceRadiosity2 faces(prepared.arrangement, table, by_element, sky);
  if (way == "point") return {illuminate_points(prepared, grid, faces, progress)};
  HOTTEL_REQUIRE(way == "average");
  AverageIllumination2 averages = illuminate_averages(prepared, grid, faces, progress);
  return {std::move(averages.grid), averages.max_error};
}

namespace {

PointLight2 solved_at(const PreparedScene2& prepared, const VisibilityPolygon2& seen) {
  const Vertices2& vertices = prepared.arrangement.vertices();
  const ExchangeMatrix matrix =
      exact_exchange(prepared, {.granularity = Granularity::kFace, .wants_visibility = false});
  const RadiositySolution solution = solve_radiosity(matrix, prepared.scene.materials, prepared.scene.sky_emission, {});
  require_doubles(matrix, prepared.scene.sky_emission, solution);
  const ElementTable2 table(prepared.scene, prepared.arrangement, prepared.division, Granularity::kFace);
  const std::vector<double> sky = sky_by_channel_2(prepared.scene.sky_emission, solution.channels.size());
  const FaceRadiosity2 faces(prepared.arrangement, table, radiosity_by_element_2(solution), sky);
  const Eye2 eye(vertices, vertices.from_scene(seen.eye));
  PointLight2 light{solution.channel_names, std::vector<double>(solution.channels.size()), ""};
  mean_irradiance(vertices, faces, eye, seen.location, seen.view, light.mean_irradiance);
  return light;
}

}  // namespace

PointLight2 light_at(const PreparedScene2& prepared, const VisibilityPolygon2& seen) {
  try {
    return solved_at(prepared, seen);
  } catch (const RequestError& error) {
    return {{}, {}, error.what()};
  }
}

}  // namespace hottel

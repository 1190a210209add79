#include "solver/plane/light/solved_light.h"

#include "geometry/plane/exchange/exchange.h"
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

RadiositySolution solved_by_faces(const PreparedScene2& prepared, const std::function<void(double)>& progress) {
  const ExchangeMatrix matrix =
      exact_exchange(prepared, {.granularity = Granularity::kFace, .wants_visibility = false, .progress = progress});
  RadiositySolution solution = solve_radiosity(matrix, prepared.scene.materials, prepared.scene.sky_emission, {});
  require_doubles(matrix, prepared.scene.sky_emission, solution);
  return solution;
}

}  // namespace

PointLights2::PointLights2(const PreparedScene2& prepared, const std::function<void(double)>& progress)
    : PointLights2(prepared, solved_by_faces(prepared, progress)) {}

PointLights2::PointLights2(const PreparedScene2& prepared, const RadiositySolution& solution)
    : vertices_(prepared.arrangement.vertices()),
      channel_names_(solution.channel_names),
      faces_(prepared.arrangement,
             ElementTable2(prepared.scene, prepared.arrangement, prepared.division, Granularity::kFace),
             radiosity_by_element_2(solution),
             sky_by_channel_2(prepared.scene.sky_emission, solution.channels.size())) {}

std::vector<double> PointLights2::at(const Eye2& eye, const Location2& location, const View2& view) const {
  std::vector<double> result(faces_.channels());
  mean_irradiance(vertices_, faces_, eye, location, view, result);
  return result;
}

std::vector<double> PointLights2::at(const PointLocation2& location, const Point2& point) const {
  const Eye2 eye(vertices_, vertices_.from_scene(point));
  View2 view;
  const Location2 place = location.look_around(eye, view);
  return at(eye, place, view);
}

PointLight2 light_at(const PreparedScene2& prepared, const VisibilityPolygon2& seen) {
  const Vertices2& vertices = prepared.arrangement.vertices();
  try {
    const PointLights2 lights(prepared);
    const Eye2 eye(vertices, vertices.from_scene(seen.eye));
    return {lights.channel_names(), lights.at(eye, seen.location, seen.view), ""};
  } catch (const RequestError& error) {
    return {{}, {}, error.what()};
  }
}

}  // namespace hottel

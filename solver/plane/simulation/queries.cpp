#include "solver/plane/simulation/queries.h"

#include "geometry/name.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/visibility/point_location.h"
#include "geometry/plane/visibility/visibility_polygon.h"
#include "kernel/support/failure.h"
#include "solver/plane/light/point_lights.h"
#include "solver/plane/simulation/simulation.h"

namespace hottel {
namespace {

template <class Look>
PointLight2 light_or_reason(const Simulation2& simulation, const StageProgress& progress, const Look& look) {
  try {
    const PointLights2 lights = point_lights(simulation, progress);
    return {lights.channel_names(), look(lights), ""};
  } catch (const RequestError& error) {
    return {{}, {}, error.what()};
  }
}

}  // namespace

Rounded view_factor(const Simulation2& simulation, const std::string& from, const std::string& to) {
  const auto factors = simulation.factors();
  const ExchangeMatrix& matrix = factors->matrix;
  const std::uint32_t row = require_element(matrix, from);
  if (row != matrix.sky()) require_chosen(simulation.request().rows, matrix, row);
  return matrix.factor(from, to);
}

ExactPair2 exact_pair(const Simulation2& simulation, const std::string& from, const std::string& to) {
  const auto prepared = simulation.prepared();
  const ExchangeMatrix columns(prepared->elements(simulation.granularity())->elements(), Guarantee::kExact);
  const std::uint32_t i = require_element(columns, from), j = require_element(columns, to);
  if (i == columns.sky()) throw UsageError("there is no pair from the sky; ask for the one to it");
  return exact_pair(*prepared, simulation.granularity(), i, j);
}

ElementRadiosity radiosity_of(const Simulation2& simulation, const std::string& element, std::size_t channel) {
  const auto factors = simulation.factors();
  const std::uint32_t row = require_element(factors->matrix, element);
  if (row == factors->matrix.sky() || !factors->matrix.has_row(row))
    throw UsageError(quoted_name(element) + " has no radiosity: it is the sky, or has no material or no area");
  const auto solution = simulation.radiosities();
  HOTTEL_REQUIRE(channel < solution->channels.size());
  return solution->channels[channel].elements[row];
}

PointLights2 point_lights(const Simulation2& simulation, const StageProgress& progress) {
  const auto solution = simulation.radiosities(progress);
  return {simulation.prepared(progress), simulation.granularity(), *solution};
}

PointLight2 light_at(const Simulation2& simulation, const Point2& point, const StageProgress& progress) {
  return light_or_reason(simulation, progress, [&](const PointLights2& lights) {
    const auto prepared = simulation.prepared(progress);
    const PointLocation2 location(prepared->arrangement.vertices(), prepared->arrangement.triangulation());
    return lights.at(location, point);
  });
}

PointLight2 light_at(const Simulation2& simulation, const VisibilityPolygon2& seen, const StageProgress& progress) {
  return light_or_reason(simulation, progress, [&](const PointLights2& lights) {
    const auto prepared = simulation.prepared(progress);
    const Vertices2& vertices = prepared->arrangement.vertices();
    return lights.at(Eye2(vertices, vertices.from_scene(seen.eye)), seen.location, seen.view);
  });
}

}  // namespace hottel

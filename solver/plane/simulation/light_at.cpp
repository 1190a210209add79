#include "solver/plane/simulation/light_at.h"

#include "kernel/support/failure.h"

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

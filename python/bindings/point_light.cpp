#include "python/bindings/point_light.h"

#include <algorithm>

#include "kernel/support/parallel.h"
#include "python/bindings/parts.h"
#include "solver/plane/light/oriented_lights.h"
#include "solver/plane/light/point_lights.h"
#include "solver/plane/simulation/queries.h"
#include "solver/space/light/oriented_lights.h"

namespace hottel::python {
namespace {

// Sets values by light(k) of each point.
template <class Light>
PointLightValues lights_of(std::size_t channels, const PythonPoints& points, const StageProgress& progress,
                           const Light& light) {
  PointLightValues result{channels, std::vector<double>(points.size() * channels)};
  in_parts(points.size(), "light at points", progress, [&](std::size_t first, std::size_t end) {
    parallel_for(end - first, [&](std::size_t k) {
      const std::vector<double> found = light(first + k);
      std::copy(found.begin(), found.end(),
                result.values.begin() + static_cast<std::ptrdiff_t>((first + k) * channels));
    });
  });
  return result;
}

}  // namespace

PointLightValues light_at_points(const Simulation2& simulation, const PythonPoints& points,
                                 const StageProgress& progress) {
  const PointLights2 lights = point_lights(simulation, progress);
  const Arrangement2& arrangement = lights.prepared().arrangement;
  const PointLocation2 location(arrangement.vertices(), arrangement.triangulation());
  return lights_of(lights.channel_names().size(), points, progress, [&](std::size_t k) {
    thread_local Point2 point;  // its memory is used again
    points.read(k, point);
    return lights.at(location, point);
  });
}

PointLightValues light_at_points(const Simulation3& simulation, const PythonPoints& points,
                                 const StageProgress& progress) {
  const auto solution = simulation.radiosities(progress);
  const auto prepared = simulation.prepared(progress);
  const OrientedLights3 lights(*prepared, simulation.request().factors.granularity, *solution);
  const Vector3 up{0, 0, 1};  // the mean over all directions is the same whatever way an area looks
  return lights_of(solution->channel_names.size(), points, progress,
                   [&](std::size_t k) { return lights.at(points.in_space(k), up).mean_irradiance; });
}

namespace {

// Sets the light of each point by light(k).
template <class Light>
AreaLightValues area_lights(std::vector<std::string> channel_names, std::size_t points, const StageProgress& progress,
                            const Light& light) {
  AreaLightValues result{std::move(channel_names), {}, {}, {}, {}};
  for (std::vector<double>* values : {&result.irradiance, &result.mean_irradiance})
    values->resize(points * result.channels.size());
  for (std::vector<double>* values : {&result.sky_view_factor, &result.mean_radiant_temperature})
    values->resize(points);
  const auto channels = static_cast<std::ptrdiff_t>(result.channels.size());
  in_parts(points, "light at points", progress, [&](std::size_t first, std::size_t end) {
    parallel_for(end - first, [&](std::size_t k) {
      const std::size_t point = first + k;
      const OrientedLight found = light(point);
      const auto place = static_cast<std::ptrdiff_t>(point) * channels;
      std::copy(found.irradiance.begin(), found.irradiance.end(), result.irradiance.begin() + place);
      std::copy(found.mean_irradiance.begin(), found.mean_irradiance.end(), result.mean_irradiance.begin() + place);
      result.sky_view_factor[point] = found.sky_view_factor;
      result.mean_radiant_temperature[point] = mean_radiant_temperature(found.mean_irradiance);
    });
  });
  return result;
}

AreaLightValues lights_on(const Simulation2& simulation, const PythonPoints& points, const PythonPoints& normals,
                          const StageProgress& progress) {
  const auto solution = simulation.radiosities(progress);
  const OrientedLights2 lights(simulation.prepared(progress), simulation.granularity(), *solution);
  return area_lights(solution->channel_names, points.size(), progress,
                     [&](std::size_t k) { return lights.at(points.in_plane(k), normals.in_plane(k)); });
}

AreaLightValues lights_on(const Simulation3& simulation, const PythonPoints& points, const PythonPoints& normals,
                          const StageProgress& progress) {
  const auto solution = simulation.radiosities(progress);
  const auto prepared = simulation.prepared(progress);
  const OrientedLights3 lights(*prepared, simulation.request().factors.granularity, *solution);
  return area_lights(solution->channel_names, points.size(), progress, [&](std::size_t k) {
    const Point3 normal = normals.in_space(k);
    return lights.at(points.in_space(k), Vector3{normal.x, normal.y, normal.z});
  });
}

}  // namespace

AreaLightValues light_on_areas(const AnySimulation& simulation, const PythonPoints& points, const PythonPoints& normals,
                               const StageProgress& progress) {
  return std::visit([&](const auto& each) { return lights_on(each, points, normals, progress); }, simulation);
}

}  // namespace hottel::python

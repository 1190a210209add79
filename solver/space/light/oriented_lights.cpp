#include "solver/space/light/oriented_lights.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/support/parallel.h"
#include "kernel/support/progress_count.h"

namespace hottel {

OrientedLights3::OrientedLights3(const PreparedScene3& prepared, Granularity granularity,
                                 const RadiositySolution& solution)
    : prepared_(prepared),
      channels_(solution.channels.size()),
      sent_out_(prepared, granularity, solution),
      lights_(prepared) {}

OrientedLight OrientedLights3::at(const Point3& point, const Vector3& normal) const {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  OrientedLight light{std::vector(channels_, kNaN), std::vector(channels_, kNaN), kNaN};
  if (prepared_.arrangement().solids().around(point)) return light;
  sent_out_.mean(point, light.mean_irradiance);
  if (std::isnan(light.mean_irradiance[0])) return light;
  lights_.add(point, light.mean_irradiance);
  light.sky_view_factor = std::max(0.0, sent_out_.irradiance(point, normal, light.irradiance));
  lights_.add(point, normal, light.irradiance);
  return light;
}

std::vector<OrientedLight> oriented_lights_on_grid(const PreparedScene3& prepared, Granularity granularity,
                                                   const RadiositySolution& solution, const Grid3& grid,
                                                   const std::function<void(double)>& progress) {
  const OrientedLights3 lights(prepared, granularity, solution);
  const Vector3 normal = cross(grid.u, grid.v);
  std::vector<OrientedLight> result(grid.cells());
  ProgressCount count(progress, result.size());
  parallel_for(
      result.size(),
      [&](std::size_t cell) {
        result[cell] = lights.at(cell_centre(grid, cell), normal);
        count.add(1);
      },
      4);
  return result;
}

std::vector<OrientedLight> lights_around(const IlluminationGrid3& light) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  std::vector<OrientedLight> result;
  result.reserve(light.grid.cells());
  for (auto at = light.values.begin(); at != light.values.end(); at += light.channels)
    result.push_back({std::vector(light.channels, kNaN), std::vector(at, at + light.channels), kNaN});
  return result;
}

}  // namespace hottel

#include "solver/space/light/oriented_lights.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

}  // namespace hottel

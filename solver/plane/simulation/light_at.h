// The light of a simulation at a point.
#pragma once

#include <string>
#include <vector>

#include "geometry/plane/visibility/visibility_polygon.h"
#include "solver/plane/light/point_lights.h"
#include "solver/plane/simulation/simulation.h"

namespace hottel {

// The mean irradiance at a point once light has been reflected until it is absorbed.       [unit: that of radiosity]
struct PointLight2 {
  std::vector<std::string> channel_names;
  std::vector<double> mean_irradiance;  // by channel; NaN in a solid
  std::string why_none;                 // no solution, or none in doubles: the reason; else empty
};

// Returns the light at a point in scene coordinates. Does not throw RequestError: where there is no solution why_none
// says why, and the lists are empty. COST: the radiosities, where they are not there, and point location.
PointLight2 light_at(const Simulation2& simulation, const Point2& point, const StageProgress& progress = {});
// The same where it is known what the point sees.
PointLight2 light_at(const Simulation2& simulation, const VisibilityPolygon2& seen, const StageProgress& progress = {});

// The same for many points: PointLights2 of this simulation. Throws RequestError where there is no solution.
PointLights2 point_lights(const Simulation2& simulation, const StageProgress& progress = {});

}  // namespace hottel

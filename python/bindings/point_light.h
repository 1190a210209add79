// Light at many points, in parts that are short enough to be ended between them.
#pragma once

#include <string>
#include <vector>

#include "python/bindings/arrays.h"
#include "python/bindings/simulation_options.h"
#include "solver/plane/simulation/simulation.h"
#include "solver/space/simulation/simulation.h"

namespace hottel::python {

// By point, then by channel.
struct PointLightValues {
  std::size_t channels = 1;
  std::vector<double> values;
};

// Returns the mean irradiance at each point; NaN in solids. Throws RequestError where there is no solution, and what
// progress throws. COST: parallel.
PointLightValues light_at_points(const Simulation2& simulation, const PythonPoints& points,
                                 const StageProgress& progress);
PointLightValues light_at_points(const Simulation3& simulation, const PythonPoints& points,
                                 const StageProgress& progress);

// The light on small areas: by point, then by channel; NaN where there is none.
struct AreaLightValues {
  std::vector<std::string> channels;
  std::vector<double> irradiance, mean_irradiance;                // by point and channel
  std::vector<double> sky_view_factor, mean_radiant_temperature;  // by point
};

// Returns the light on a small area at each point. Throws RequestError where there is no solution, InputError for a
// normal that is zero, and what progress throws. REQUIRES as many of both. COST: parallel.
AreaLightValues light_on_areas(const AnySimulation& simulation, const PythonPoints& points, const PythonPoints& normals,
                               const StageProgress& progress);

}  // namespace hottel::python

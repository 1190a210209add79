// Common questions to a simulation in the plane, by name.
#pragma once

#include <cstddef>
#include <string>

#include "geometry/plane/point.h"
#include "kernel/enclosure.h"
#include "solver/plane/light/light_values.h"
#include "solver/radiosity/radiosity_solution.h"

namespace hottel {

class Simulation2;

// Each makes the stages that it needs, and throws what they throw (simulation.h). Names are those of the rows:
// "wall", "wall:back", or "wall#2" where they are elements; UnknownName where there is none.

// Returns F(from, to), `to` may be "sky"; as ExchangeMatrix::factor.
Rounded view_factor(const Simulation2& simulation, const std::string& from, const std::string& to);

// Returns the radiosity of an element in a channel, with its bounds, and what goes with it. Throws UsageError where the
// element has no row. REQUIRES a channel of the solution.
ElementRadiosity radiosity_of(const Simulation2& simulation, const std::string& element, std::size_t channel = 0);

// Returns the mean irradiance at a point of the scene, by channel; NaN in a solid.
//
//   (1) the same, bit for bit, as that of a cell of light() of kind "point" whose centre the point is
// Does not throw RequestError: where there is no solution, or none that doubles can hold, why_none says why.
// COST: beside the radiosities, linear in the scene; light() has many points at once.
PointLight2 light_at(const Simulation2& simulation, const Point2& point);

}  // namespace hottel

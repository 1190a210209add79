// Common queries to a simulation in the plane: about faces by name, and about points.
//
//   const Simulation2 simulation(read_scene_2("scenes/analytic/square_radiosity.json"));
//   std::printf("F = %.17g\n", view_factor(simulation, "bottom", "top").value);
//   std::printf("S = %s\n", exact_pair(simulation, "bottom", "top").exchange.to_string().c_str());
//   std::printf("B = %.6g\n", radiosity_of(simulation, "bottom").radiosity);
//   std::printf("%.6g\n", light_at(simulation, {Rational(1, 2), Rational(1, 3)}).mean_irradiance[0]);
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geometry/plane/exchange/closed_forms.h"
#include "geometry/plane/point.h"
#include "kernel/enclosure.h"
#include "kernel/support/interrupt.h"
#include "solver/radiosity/radiosity_solution.h"

namespace hottel {

class PointLights2;
class Simulation2;
struct VisibilityPolygon2;

// Each computes the stages that it needs, and throws what they throw (simulation.h), unless it says otherwise. Names
// are those of rows: "wall", "wall:back", or "wall#2" if faces are divided. Throws UnknownName for other names.

// Returns F(from, to), as ExchangeMatrix::factor; `to` may be "sky". By a method that is not exact it is an estimate,
// and its enclosure() proves nothing. Throws UsageError where `from` is the sky, or has no row, or its row was not
// chosen.
Rounded view_factor(const Simulation2& simulation, const std::string& from, const std::string& to);

// Returns the direct exchange area S of a pair in closed form, with S0, what it would be with nothing between, and both
// areas, all in the unit in which the scene is typed. It is exact whatever the method of the simulation. Names are
// those of columns: `from` may be without a row; `to` may be "sky", whose area is left 0. Throws UsageError where
// `from` is the sky.
ExactPair2 exact_pair(const Simulation2& simulation, const std::string& from, const std::string& to);

// Returns the result for an element in a channel: its radiosity with bounds, irradiance and net flux. Throws
// UsageError if the element has no row. REQUIRES a channel of the solution.
ElementRadiosity radiosity_of(const Simulation2& simulation, const std::string& element, std::size_t channel = 0);

// The mean irradiance at a point, with all reflections: the mean of the radiosities seen there over all directions.
// [unit: that of radiosity]
struct PointLight2 {
  std::vector<std::string> channel_names;
  std::vector<double> mean_irradiance;  // by channel; NaN in a solid and outside a closed scene, infinite at a light
  std::string why_none;                 // the RequestError that was met; empty where there is light
};

// Returns the light at a point in scene coordinates. Throws no RequestError: if a stage meets one, too little memory
// and a broken promise included, why_none is its text, and the lists are empty. COST: the radiosities, if they are not
// computed yet, and point location.
PointLight2 light_at(const Simulation2& simulation, const Point2& point, const StageProgress& progress = {});
// The same for a caller who knows already what the point sees. For the program: no installed header has the type.
PointLight2 light_at(const Simulation2& simulation, const VisibilityPolygon2& seen, const StageProgress& progress = {});

// The same for many points: PointLights2 of this simulation. Throws RequestError where there is no solution. For the
// program: no installed header has the type.
PointLights2 point_lights(const Simulation2& simulation, const StageProgress& progress = {});

}  // namespace hottel

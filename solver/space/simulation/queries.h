// Common queries to a simulation in space: about faces by name.
//
//   const Simulation3 simulation(read_scene_3("scenes/space/cube.json"), {.factors = {.tolerance = 1e-12}});
//   const KnownFactor3 f = view_factor(simulation, "floor", "ceiling");
//   std::printf("F = %.12f in [%.15f, %.15f]\n", f.value, f.bounds.lower, f.bounds.upper);
//   std::printf("B = %.9f\n", radiosity_of(simulation, "floor").radiosity);
#pragma once

#include <cstddef>
#include <string>

#include "kernel/enclosure.h"
#include "kernel/support/interrupt.h"
#include "solver/radiosity/radiosity_solution.h"

namespace hottel {

struct SceneCheck3;
class Simulation3;

// A view factor, and what is known of it.
struct KnownFactor3 {
  double value = 0;
  Enclosure bounds{0, 0};                      // proven
  Guarantee guarantee = Guarantee::kEnclosed;  // of the value: kEnclosed, or kEstimated to the tolerance
};

// Each computes the stages that it needs, and throws what they throw (simulation.h), unless it says otherwise. Names
// are those of rows: "wall", "wall:back", or "wall#2" if faces are divided. Throws UnknownName for other names.

// Returns F(from, to); `to` may be "sky". By the exact method it is exactly 0 where the two exchange nothing; by
// another one a pair without an entry is 0 in [0, 1], estimated. Throws UsageError where `from` has no row, or its row
// was not chosen.
KnownFactor3 view_factor(const Simulation3& simulation, const std::string& from, const std::string& to);

// Returns the result for an element in a channel: its radiosity with bounds, irradiance and net flux. Throws
// UsageError if the element has no row. REQUIRES a channel of the solution.
ElementRadiosity radiosity_of(const Simulation3& simulation, const std::string& element, std::size_t channel = 0);

// Returns what is worth telling about the scene (check_scene), with what the simulation has of it. REQUIRES factors by
// faces. Throws what check_scene and progress throw.
SceneCheck3 scene_check(const Simulation3& simulation, const StageProgress& progress = {});

}  // namespace hottel

// Common questions to a simulation in space: of faces by name.
#pragma once

#include <cstddef>
#include <string>

#include "kernel/enclosure.h"
#include "kernel/support/stage.h"
#include "solver/radiosity/radiosity_solution.h"

namespace hottel {

struct SceneCheck3;
class Simulation3;

// A view factor, what is known of it, and Vis.
struct KnownFactor3 {
  double value = 0;
  Enclosure bounds{0, 0};                      // proven
  Guarantee guarantee = Guarantee::kEnclosed;  // of the value: kEnclosed, or kEstimated to the tolerance
};

// Each makes the stages that it needs, and throws what they throw (simulation.h), unless it says otherwise. Names are
// those of the rows: "wall", "wall:back", "wall#2" where they are elements; UnknownName where there is none.

// Returns F(from, to), `to` may be "sky"; by the exact method exactly 0 where nothing goes from one to the other.
// Throws UsageError where `from` has no row.
KnownFactor3 view_factor(const Simulation3& simulation, const std::string& from, const std::string& to);

// Returns the radiosity of an element in a channel, with its bounds, and what goes with it. Throws UsageError where the
// element has no row. REQUIRES a channel of the solution.
ElementRadiosity radiosity_of(const Simulation3& simulation, const std::string& element, std::size_t channel = 0);

// Returns what is worth telling about the scene (check_scene), with what the simulation has of it. REQUIRES factors by
// faces. Throws what check_scene and progress throw.
SceneCheck3 scene_check(const Simulation3& simulation, const StageProgress& progress = {});

}  // namespace hottel

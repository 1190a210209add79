// A simulation in the plane whose surfaces are divided where light ends.
#pragma once

#include "solver/plane/simulation/simulation.h"
#include "solver/refinement.h"

namespace hottel {

// The version of a simulation whose scene has the trees of refined_trees, and rows for its elements.
//
//   (1) its values are those of a new simulation of that scene; the overlay is shared with the version before
//   (2) levels of 0 return the simulation as it is
// Throws as Simulation2::prepared does. COST: that of refined_trees.
Simulation2 refined(const Simulation2& simulation, const RefinementLevels& levels, const StageProgress& progress = {});

}  // namespace hottel

// A simulation in space whose polygons are divided where light ends.
#pragma once

#include "solver/refinement.h"
#include "solver/space/simulation/simulation.h"

namespace hottel {

// The version of a simulation whose scene has the trees of refined_trees.
//
//   (1) its values are those of a new simulation of that scene; what is arranged is shared with the version before
//   (2) levels of 0 return the simulation as it is
// REQUIRES that rows are asked for by element. Throws as Simulation3::prepared does. COST: that of refined_trees.
Simulation3 refined(const Simulation3& simulation, const RefinementLevels& levels, const StageProgress& progress = {});

}  // namespace hottel

// The radiosities of a scene, and what is to be said of them.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "geometry/scene_table.h"
#include "solver/radiosity/direct_light.h"
#include "solver/radiosity/radiosity_solution.h"
#include "solver/radiosity/radiosity_solver.h"

namespace hottel {

// Solves a system for what the materials, the lights and the sky of a scene emit. `lights`: the shares of each light.
//
//   (1) where factors are enclosed and none is estimated, bounds are narrowed by those that hold whatever the factors
//       are (set_a_priori_bounds)
//   (2) the notes are those given, then lights that are lost (lost_light_notes), then what follows of the guarantee,
//       then those of the solver; the seconds of the system are among those of the radiosities
//   (3) where shares of lights are estimates, so is the solution; what they lack of the power is a defect of the energy
//   (4) a face of given net flux, or an insulated one, whose sigma T⁴ has an upper bound below 0 is refused by name,
//   and so is an insulated
//       one that gains light in the solar band and has no emissivity; materials that say nothing of the solar band are
//       named in a note
//
// REQUIRES the system of the scene's reflectivities and a matrix of its elements. Throws RequestError, naming the
// scene's file, as RadiositySolver and require_doubles do.
RadiositySolution scene_radiosities(const RadiositySolver& system, const SceneTable& scene,
                                    std::span<const LightShares> lights, std::vector<std::string> notes,
                                    const std::function<void(double)>& progress);

}  // namespace hottel

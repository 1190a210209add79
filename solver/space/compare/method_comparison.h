// Approximate methods beside the exact one, on one scene in space.
#pragma once

#include "geometry/space/prepared/prepared_scene.h"
#include "solver/compare/method_comparison.h"
#include "solver/space/methods/exchange_method.h"
#include "solver/space/simulation/simulation.h"

namespace hottel {

struct VerdictWatch;
struct Grid3;
struct IlluminationGrid3;

// A scene in space, ready to judge methods: as MethodComparison.
class MethodComparison3 : public MethodComparison<PreparedScene3> {
 public:
  // Of the simulation only the scene, the tolerance, whether factors must be enclosed, and the memory allowed matter.
  // COST: the exact factors and one solution.
  explicit MethodComparison3(const Simulation3& simulation, const StageProgress& progress = {});
};

// Adds the verdict in words to the notes of a result whose factors were read from a file or came from a command; does
// nothing to others. REQUIRES a result of this comparison, with its matrix. beyond: as in VerdictOptions.
void add_verdict(const MethodComparison3& comparison, double beyond, MethodResult& result);
// The same, told to others as it is found.
void add_verdict(const MethodComparison3& comparison, double beyond, MethodResult& result, const VerdictWatch& watch);

// Returns the exact light at the centres of the cells of a grid (illuminate_points), with that of lights, by the exact
// radiosities. Throws RequestError where there are none. COST: that of illuminate_points.
IlluminationGrid3 exact_light_on(const MethodComparison3& comparison, const Grid3& grid);

}  // namespace hottel

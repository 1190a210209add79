// Approximate methods beside the exact one, on one scene in the plane.
//
//   const MethodComparison2 comparison{Simulation2(read_scene_2("scenes/analytic/strip_obstructed.json"))};
//   std::printf("gauss:4 errs by %.2g\n", comparison.run(*method_2("gauss:4")).errors.max);
//   MethodResult result = comparison.run(*method_2("file:factors.csv"));
//   add_verdict(comparison, 1e-6, result);
//   for (const std::string& note : result.notes) std::printf("%s\n", note.c_str());
#pragma once

#include "solver/compare/method_comparison.h"
#include "solver/plane/methods/exchange_method.h"
#include "solver/plane/simulation/simulation.h"

namespace hottel {

struct VerdictWatch;
struct Grid2;
struct IlluminationGrid2;

// A scene in the plane, ready to judge methods: as MethodComparison.
class MethodComparison2 : public MethodComparison<PreparedScene2> {
 public:
  // Takes the scene and the allowed memory of the simulation; shares its exact factors where they are by elements and
  // with visibilities. COST: the exact factors and one solution.
  explicit MethodComparison2(const Simulation2& simulation, const StageProgress& progress = {});
};

// Adds the verdict in words to the notes of a result whose factors were read from a file or came from a command; does
// nothing to other results. beyond: a pair is off where its factor is wrong by more than this,
// absolutely, and by more than the file's rounding; 1e-6 is usual. REQUIRES a result of this comparison, with its
// matrix.
void add_verdict(const MethodComparison2& comparison, double beyond, MethodResult& result);
// The same; `watch` is told of laws and findings as they are found.
void add_verdict(const MethodComparison2& comparison, double beyond, MethodResult& result, const VerdictWatch& watch);

// Returns the exact light at the centres of the cells of a grid (illuminate_points), with that of lights, by the exact
// radiosities. Throws RequestError where there are none. COST: that of illuminate_points.
IlluminationGrid2 exact_light_on(const MethodComparison2& comparison, const Grid2& grid);

}  // namespace hottel

// A scene in space, simulated: each result is computed when it is first asked for, and kept.
//
//   const Simulation3 simulation(read_scene_3("scenes/space/cube.json"), {.factors = {.tolerance = 1e-12}});
//   const auto factors = simulation.factors();
//   std::printf("%u elements\n", factors->matrix.size());
//   std::printf("B = %.9f\n", simulation.radiosities()->channels[0].elements[0].radiosity);
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/element.h"
#include "geometry/space/scene/scene.h"
#include "kernel/support/interrupt.h"
#include "solver/plan.h"
#include "solver/radiosity/radiosity_options.h"
#include "solver/radiosity/radiosity_solution.h"
#include "solver/space/methods/computed_factors.h"

namespace hottel {

class RadiositySolver;
struct DividingEstimate;
struct IlluminationGrid3;
struct LightShares;
struct PreparedScene3;

// A picture of light as its painter made it: the bytes of an image file, or what else the painter returns.
struct LightPicture3 {
  std::string bytes;
  double seconds = 0;  // the time it took, measured by the simulation
};

// Draws light. The solver knows nothing of pictures; a caller who wants one passes a painter.
class LightPainter3 {
 public:
  virtual ~LightPainter3() = default;
  // Draws light on a grid. The same light gives the same picture. Threads may share one.
  virtual LightPicture3 paint(const IlluminationGrid3& light) const = 0;
};

// On which grid light between the faces is computed, planar or a volume, and who draws it; two painters are equal if
// they are the same object.
struct LightRequest3 {
  std::optional<Grid3> grid = {};                          // nothing: the first of the scene
  std::shared_ptr<const LightPainter3> painter = nullptr;  // null: no picture can be asked for
  // Two quantities. False: the mean irradiance at the centre of each cell, over all directions. True: the irradiance of
  // each cell, averaged over it, on the side to which u x v points.
  bool is_average = false;
  friend bool operator==(const LightRequest3&, const LightRequest3&) = default;
};

// A request.
struct SimulationRequest3 {
  FactorsRequest3 factors{};
  RadiosityOptions system{};  // its `progress` is not called: stages tell how far they are
  LightRequest3 light{};
  LightTest lights = LightTest::kExact;  // how elements are lit by the scene's lights; light on the grid stays exact
  PlanRequest plan{};                    // what the plan counts
  friend bool operator==(const SimulationRequest3&, const SimulationRequest3&) = default;
};

// One version of a scene and of a request, with all results, in stages ("a <- b": b is computed from a):
//
//   prepared <- factors <- system <- radiosities <- light <- picture
//   prepared <- lights <- radiosities
//
// Hidden pairs are computed from the factors, dividing(), the estimate of what dividing the elements once more would
// change, from the radiosities. plan is apart from this chain.
//
// A version never changes. The first call for a stage computes it, and the stages that it needs; every call returns it
// as a shared value that may outlive the version.
//
//   (1) every value is a function of scene and request: bit for bit that of a new simulation, whatever was asked or
//       cancelled before, on any number of threads (but `seconds` in reports are measured)
//   (2) any number of threads may ask one version at once; stages are made, waited for, cancelled and failed as
//       kernel/support/stage.h says
//   (3) a version with another request shares the prepared scene. It shares each of plan, factors, lights, system,
//       radiosities, light and picture if the two requests agree on it and on all that it is computed from. Hidden
//       pairs go with the factors, the estimate of dividing with the radiosities
//   (4) a version with other materials shares the factors if the same pairs of materials act alike, which they do if
//       they are equal but for their names, and the system too if no reflectivity changed. Else the scene is arranged
//       anew: either that is refused (InputError), or all lies as before, and the factors are copied
//   (5) a version with a scene of the same shape, whose materials act alike as before, shares the arrangement, however
//       surfaces are divided. It shares the factors too if surfaces are divided alike, and then the stage `lights` if
//       all lights have the same names, places, directions and beams; their powers may differ
//   (6) radiosities and what is computed from them are shared unless one of these changed: the system, emissions, that
//       of the sky, lights, the promise `closed`
//
// Light and picture are computed from the solution, on the grid; they are computed again whenever the solution is.
// RequestErrors name the scene's file. They are thrown if memory does not suffice, a pair cannot be measured or has no
// enclosure though it must, the promise `closed` is broken, or there is no solution, or none in doubles.
class Simulation3 {
 public:
  // A Scene3 is validated: throws InputError naming file, line and surface unless it is valid (validate). Throws
  // UsageError where the request's grid is not valid (grid_problem), or averages are asked for in a volume;
  // with_request() throws the same.
  explicit Simulation3(ValidScene3 scene, SimulationRequest3 request = {});
  Simulation3 with_request(const SimulationRequest3& request) const;
  // The same scene with these materials, one in place of each of its own. Throws InputError as the constructor does,
  // ContractViolation unless there are as many.
  Simulation3 with_materials(std::vector<Material> materials) const;
  // The version of another scene. Throws as the constructor.
  Simulation3 with_scene(Scene3 scene) const;
  Simulation3 with_scene(ValidScene3 scene) const;
  // The same scene with these trees in place of its own; an empty one divides nothing further. TreeNode::part counts
  // the parts of its polygon: n^2 of a triangle or quad divided by n, those of each of its triangles for others. Throws
  // ContractViolation unless there is one for each surface; so does what needs the elements, unless each is whole
  // (are_whole, with 4 children).
  Simulation3 with_trees(std::vector<SurfaceTrees> trees) const;

  const Scene3& scene() const;
  const SimulationRequest3& request() const;
  std::optional<Grid3> grid() const;  // where light is asked for: the request's, else the scene's first

  // The stages. progress: as Stage::get() takes it; it is told of "view factors", "radiosity" and "illumination".
  std::shared_ptr<const Plan> plan(const StageProgress& progress = {}) const;
  std::shared_ptr<const PreparedScene3> prepared(const StageProgress& progress = {}) const;
  std::shared_ptr<const ComputedFactors3> factors(const StageProgress& progress = {}) const;
  // Throws RequestError where the scene promises to be closed and is not, whatever the method. Factors themselves do
  // not ask.
  void require_closed(const StageProgress& progress = {}) const;
  std::shared_ptr<const std::vector<LightShares>> light_shares(const StageProgress& progress = {}) const;
  std::shared_ptr<const RadiositySolver> system(const StageProgress& progress = {}) const;
  std::shared_ptr<const RadiositySolution> radiosities(const StageProgress& progress = {}) const;
  std::shared_ptr<const DividingEstimate> dividing(const StageProgress& progress = {}) const;
  // REQUIRES a grid, and picture() a planar one and a painter in the request; both throw ContractViolation otherwise.
  std::shared_ptr<const IlluminationGrid3> light(const StageProgress& progress = {}) const;
  std::shared_ptr<const LightPicture3> picture(const StageProgress& progress = {}) const;
  // The pairs (from, to) that are hidden, S = 0 < S0, of the rows that are chosen: sorted by `from`, then `to`, the sky
  // last. (i, j) and (j, i) are both listed where both have rows, (i, sky) where i does not see the sky. REQUIRES the
  // exact method: what others leave out is listed as well.
  std::shared_ptr<const std::vector<ElementPair>> hidden(const StageProgress& progress = {}) const;

 private:
  struct Version;
  explicit Simulation3(std::shared_ptr<const Version> version) : version_(std::move(version)) {}

  std::shared_ptr<const Version> version_;
};

}  // namespace hottel

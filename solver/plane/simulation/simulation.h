// A scene in the plane, simulated: each result is computed when it is first asked for, and kept while it is valid.
//
//   const Simulation2 day(read_scene_2("scenes/analytic/square_radiosity.json"));
//   Scene2 scene = day.scene();
//   material_called(scene, "lit").emission = Spectrum::scalar(2);
//   const Simulation2 night = day.with_scene(scene);
//   for (const Simulation2& each : {day, night})
//     std::printf("B = %.6g\n", each.radiosities()->channels[0].elements[0].radiosity);
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/exchange_request.h"
#include "geometry/plane/scene/scene.h"
#include "kernel/support/interrupt.h"
#include "solver/plan.h"
#include "solver/plane/light/light_values.h"
#include "solver/plane/methods/computed_factors.h"
#include "solver/radiosity/radiosity_options.h"
#include "solver/radiosity/radiosity_solution.h"

namespace hottel {

template <class Prepared>
class ExchangeMethod;
class FactorStore;
class LightRows2;
class RadiositySolver;
struct DividingEstimate;
struct Finding2;
struct LightShares;
struct PreparedScene2;
struct SceneCheck2;

// A picture of light as its painter made it: the bytes of an image file, or what else the painter returns.
struct LightPicture2 {
  std::string bytes;
  double scale = 1;    // factor that values were multiplied by before the tone curve
  double seconds = 0;  // the time it took, measured by the simulation
};

// Draws light. The solver knows nothing of pictures; a caller who wants one passes a painter.
class LightPainter2 {
 public:
  virtual ~LightPainter2() = default;
  // Draws the light of a scene. The same arguments give the same picture. Throws UsageError where it cannot be drawn.
  // Threads may share one.
  virtual LightPicture2 paint(const PreparedScene2& prepared, const IlluminationGrid2& light) const = 0;
};

// A request, with the defaults.
//
//   (1) two requests are equal if all their members are; methods and painters are equal if they are the same object
struct SimulationRequest2 {
  std::shared_ptr<const ExchangeMethod<PreparedScene2>> method = {};  // null: the exact one
  std::optional<Granularity> granularity = {};  // nothing: elements if a surface is divided or `everything`, else faces
  bool wants_visibility = false, wants_measures = false;  // beside the factors
  // As ExchangeRequest takes them, for factors() alone: system(), radiosities() and what is computed from them throw
  // UsageError unless all rows are chosen.
  RowChoice rows = {};
  bool everything = false;         // every effect (Plan), also those the scene does not need
  RadiosityOptions system = {};    // its `progress` is not called: stages tell how far they are
  std::optional<Grid2> grid = {};  // nothing: default_grid(scene); the plan then counts all grids of the scene
  bool wants_light = true;         // whether plan() counts light; light() computes it anyway
  bool wants_picture = true;       // whether plan() counts a picture
  LightKind2 light = LightKind2::kPoint;
  LightTest lights = LightTest::kExact;  // how elements are lit by the scene's lights; light in the rooms stays exact
  bool keeps_rows = false;  // of kPoint: what the cells see is kept, and light after an edit of materials made of it
  std::shared_ptr<const LightPainter2> painter = {};  // null: no picture can be asked for
  // Bytes that factors may take; 0: four fifths of what is free when they are computed. Where they need more, factors()
  // throws RequestError.
  std::uint64_t memory = 0;
  // Factors that it has are read from it, others are written to it once they are computed. All rows are computed then,
  // whatever `rows` chooses. No number depends on it. For the program: no installed header has the type.
  std::shared_ptr<FactorStore> store = {};

  friend bool operator==(const SimulationRequest2&, const SimulationRequest2&) = default;
};

// One version of a scene and of a request, with all results, in stages ("a <- b": b is computed from a):
//
//   arrangement <- factors <- system <- radiosities <- light <- picture
//   arrangement <- lights <- radiosities
//   arrangement <- rows <- light, where rows are kept
//
// dividing(), the estimate of what dividing the elements once more would change, is computed from the radiosities.
// plan, lost_light and check are apart from this chain.
// prepared() is the arrangement with the scene of this version; light_shares() is the stage `lights`.
//
// A version never changes. An edit makes a new one, which shares every stage whose input is the same. So undoing means
// going back to the older version, and copies are cheap. The first call for a stage computes it, and the stages that it
// needs; every call returns it as a shared value that may outlive the version.
//
//   (1) a stage is dropped by an edit iff its input changed, directly or in a stage before it:
//         arrangement   edges, surfaces, groups, names, which materials act alike; whether elements are told apart
//         factors       method, granularity, choice of rows, visibilities, measures, `everything`, memory, store
//         system        reflectivities; how it is solved
//         lights        their places, directions and beams, and the test of what they light, after the arrangement
//         radiosities   emissions, that of the sky, the power of lights, the promise `closed`
//         rows          grid, granularity, memory: what the cells see (light_rows.h), after the arrangement
//         light         grid, kind of light. Made from rows where they are kept: the same bits
//         picture       painter
//         dividing      only what changes the radiosities
//         plan, lost_light, check    anything in the scene, and what they use: the grid, factors
//   (2) every value but the measured `seconds` of reports is a function of scene and request: bit for bit that of a new
//       simulation of the same scene, whatever was edited, asked or cancelled before, on any number of threads, and
//       also after the scene was written and read again
//   (3) any number of threads may ask one version at once; stages are made, waited for, cancelled and failed as
//       kernel/support/stage.h says. An error of a stage is thrown again by every later call until an edit
//       drops the stage; one that was cancelled is computed by the next call
//   (4) factors and what cells see each keep to the memory that is allowed (ExchangeRequest::memory, LightRows2)
//
// RequestErrors name the scene's file. Stages throw what their functions throw: InputError where surfaces that overlap
// give one place different materials, or a "behind" cannot be obeyed (prepare); RequestError where the memory does not
// suffice, where a method cannot be run, where the promise `closed` is broken (judged by exact factors, whatever the
// method), where a factor is negative, where there is no solution, or none in doubles.
class Simulation2 {
 public:
  // A Scene2 is validated: throws InputError naming file, line and surface unless it is valid (validate). Throws
  // UsageError where the request's grid is not valid (grid_problem).
  explicit Simulation2(ValidScene2 scene, SimulationRequest2 request = {});

  // The version after an edit. COST: linear in the scene, which is compared with that of this version.
  Simulation2 with_scene(ValidScene2 scene) const;  // throws as the constructor does
  // The same scene with these trees in place of its own; an empty one divides nothing further. Throws ContractViolation
  // unless there is one for each surface, and each that is not empty is whole (are_whole, with 2 children, of
  // Surface::elements parts).
  Simulation2 with_trees(std::vector<SurfaceTrees> trees) const;
  Simulation2 with_request(SimulationRequest2 request) const;  // throws UsageError as the constructor does

  const Scene2& scene() const;
  const SimulationRequest2& request() const;
  const Grid2& grid() const;        // where light is asked for: the request's, else default_grid(scene())
  Granularity granularity() const;  // what has rows: as the request says, or by its default

  // The stages. progress: as Stage::get() takes it; it is told of "view factors", "radiosity", "illumination", and of
  // others as they run.
  std::shared_ptr<const Plan> plan(const StageProgress& progress = {}) const;
  std::shared_ptr<const PreparedScene2> prepared(const StageProgress& progress = {}) const;  // with this scene
  std::shared_ptr<const ComputedFactors2> factors(const StageProgress& progress = {}) const;
  // Throws RequestError where the scene promises to be closed and is not. factors() does not.
  void require_closed(const StageProgress& progress = {}) const;
  std::shared_ptr<const RadiositySolver> system(const StageProgress& progress = {}) const;
  std::shared_ptr<const std::vector<LightShares>> light_shares(const StageProgress& progress = {}) const;
  std::shared_ptr<const RadiositySolution> radiosities(const StageProgress& progress = {}) const;
  std::shared_ptr<const DividingEstimate> dividing(const StageProgress& progress = {}) const;
  std::shared_ptr<const LightRows2> rows(const StageProgress& progress = {}) const;
  std::shared_ptr<const SolvedLight2> light(const StageProgress& progress = {}) const;
  // REQUIRES a painter in the request; throws ContractViolation otherwise.
  std::shared_ptr<const LightPicture2> picture(const StageProgress& progress = {}) const;
  // lost_light: warnings of light that is lost, by factors(): they are those of `check` only where the method is exact
  // and all rows are chosen. REQUIRES that granularity() is not kGroup. check: all findings of `check`, by the exact
  // factors of all rows, whatever the request says.
  std::shared_ptr<const std::vector<Finding2>> lost_light(const StageProgress& progress = {}) const;
  std::shared_ptr<const SceneCheck2> check(const StageProgress& progress = {}) const;

 private:
  struct Version;
  explicit Simulation2(std::shared_ptr<const Version> version) : version_(std::move(version)) {}

  std::shared_ptr<const Version> version_;
};

}  // namespace hottel

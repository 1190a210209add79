// What hottel solve does with a simulation of either dimension: factors, radiosities, tables, light, the report.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "cli/machine_speed.h"
#include "cli/scene_input.h"
#include "cli/solve_files.h"
#include "cli/solve_options.h"
#include "cli/streams.h"
#include "cli/unit_notes.h"
#include "io/results/grid_file.h"
#include "io/results/plane/check_report.h"
#include "io/results/solve_report.h"
#include "io/results/space/check_report.h"
#include "io/results/space/factors_report.h"
#include "kernel/support/stopwatch.h"
#include "solver/plan_speed.h"
#include "solver/plane/methods/computed_factors.h"
#include "solver/plane/simulation/simulation.h"
#include "solver/space/check/lost_light.h"
#include "solver/space/simulation/simulation.h"
#include "solver/store_plan.h"

namespace hottel {

// What both simulations have, and each says in its own way.
inline const ExchangeReport& exchange_report(const ComputedFactors2& factors) { return factors.report.counts; }
inline const ExchangeReport3& exchange_report(const ComputedFactors3& factors) { return factors.report; }
inline Findings2 lost_light(const Simulation2& simulation, const StageProgress& progress) {
  return *simulation.lost_light(progress);
}
inline Findings3 lost_light(const Simulation3& simulation, const StageProgress& progress) {
  return lost_light_warnings(simulation.scene(), simulation.factors(progress)->matrix);
}
inline const std::shared_ptr<FactorStore>& store_of(const Simulation2& simulation) {
  return simulation.request().store;
}
inline const std::shared_ptr<FactorStore>& store_of(const Simulation3& simulation) {
  return simulation.request().factors.store;
}

// Tells what the run will do, and returns it.
template <class Simulation>
Plan told_plan(const SolveOptions& options, const Simulation& simulation, Streams& streams) {
  Plan plan = plan_at_speed(*simulation.plan(), machine_speed());
  constexpr bool kIsInSpace = std::is_same_v<Simulation, Simulation3>;
  if (options.store.is_given()) plan = plan_with_store(plan, kIsInSpace, options.method);
  streams.note(plan_text(plan));
  return plan;
}

// Throws RequestError where light on these grids needs more memory or disk than there is.
template <class Grid>
void require_room_for_grids(const SolveOptions& options, const std::vector<Grid>& grids, const SceneTable& scene,
                            const std::filesystem::path& directory) {
  for (const Grid& grid : grids)
    require_room_for_light(options, cells_text(grid), grid.cells(), channel_count(scene), "take a coarser --grid",
                           directory);
}

// Names the files of a run outside its folder: lines for people, each after a newline. pictures: those of --render.
template <class Grid>
std::string told_elsewhere(const SolveOptions& options, const std::vector<Grid>& grids, const std::string& pictures) {
  return (options.views.empty() ? "" : "\nwhat the cells see: " + names_of_grid_files(options.views, grids)) +
         (options.render.empty() ? "" : "\nthe picture: " + pictures);
}

// What a run solves, and where its results go.
template <class Simulation>
struct SolveRun {
  const SolveOptions& options;
  const Simulation& simulation;
  const Plan& plan;
  double seconds_to_read;  // the scene
  SolveFiles& files;
  Streams& streams;
};

// Solves, and writes all files of a run.
//
// outputs: the files that scenes of this dimension have beside the tables. It has
//   write_elements(solved, report)  writes what elements have: pictures or meshes of them
//   write_light(solved, report)     writes light between the faces, and pictures of it; adds what the report says of
//                                   them, and the seconds that they took
//   told()                          told_elsewhere()
template <class Simulation, class Outputs>
void solve_and_write(const SolveRun<Simulation>& run, Outputs& outputs) {
  const auto& [options, simulation, plan, seconds_to_read, files, streams] = run;
  const auto& scene = simulation.scene();
  const auto factors = simulation.factors(streams.stages());
  const ExchangeMatrix& matrix = factors->matrix;
  const auto lost = lost_light(simulation, streams.stages());
  if (!lost.empty()) streams.note(findings_text(scene, lost));
  const auto solution = simulation.radiosities(streams.stages());
  const auto dividing = simulation.dividing(streams.stages());

  Stopwatch watch;
  const NetFluxes fluxes(scene, matrix, *solution, *simulation.light_shares());
  const Solved solved{scene, matrix, *solution, fluxes};
  files.write_tables(solved, options.digits);
  SolveReport report{.scene = options.scene,
                     .plan = &plan,
                     .factors = factor_counts(exchange_report(*factors)),
                     .solution = solution.get(),
                     .fluxes = &fluxes,
                     .seconds = exchange_report(*factors).seconds,
                     .insulated = insulated_groups(scene, matrix, *solution),
                     .given_flux = given_flux_groups(scene, matrix, *solution),
                     .unit = scene.unit,
                     .store = options.store.report(store_of(simulation)),
                     .dividing = dividing.get(),
                     .warnings = with_unit_note(scene, finding_notes(lost))};
  report.seconds.insert(solution->seconds.begin(), solution->seconds.end());
  if (dividing->seconds > 0) report.seconds["dividing"] = dividing->seconds;
  report.seconds["read"] = seconds_to_read;
  outputs.write_elements(solved, report);
  report.seconds["write"] = watch.lap();
  outputs.write_light(solved, report);
  files.finish(options, report, solved, outputs.told(), streams);
}

}  // namespace hottel

// hottel plan: what solve would simulate of a scene, and what not.
#include <utility>

#include "cli/command.h"
#include "cli/machine_speed.h"
#include "cli/scene_input.h"
#include "io/results/solve_report.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "solver/plan_speed.h"
#include "solver/plane/simulation/simulation.h"
#include "solver/space/simulation/simulation.h"

namespace hottel {
namespace {

struct PlanOptions {
  std::string scene, grid;
  ElementOptions elements;
  PolygonOptions polygons;
  bool json = false;
};

std::shared_ptr<const Plan> plan_of(const PlanOptions& options, Scene2 scene) {
  options.elements.apply_to(scene);
  const Grid2 grid = grid_of(scene, options.grid);
  return Simulation2(std::move(scene), {.grid = grid}).plan();
}

std::shared_ptr<const Plan> plan_of(const PlanOptions& options, Scene3 scene) {
  options.elements.apply_to(scene);
  const std::optional<Grid3> grid = grid_of(scene, options.grid);
  const std::uint64_t cells = grid ? std::uint64_t{grid->nu} * grid->nv : 0;
  return Simulation3(std::move(scene), {.plan = {.everything = false, .grid_cells = cells}}).plan();
}

ExitCode plan(const PlanOptions& options, Streams& streams) {
  const auto plan = std::visit([&](auto&& scene) { return plan_of(options, std::move(scene)); },
                               read_scene_noting(options.scene, options.polygons, streams));
  const Plan here = plan_at_speed(*plan, machine_speed());
  streams.write("", options.json ? plan_json(options.scene, here) : plan_text(here));
  return ExitCode::kDone;
}

}  // namespace

void add_plan(Commands& commands) {
  const auto options = std::make_shared<PlanOptions>();
  CLI::App& command = commands.add(
      "plan", "What solve would simulate, what not, why, and what it costs",
      {"hottel plan scenes/showcase/apartment.json", "hottel plan scenes/analytic/square_radiosity.json --json",
       "hottel plan scenes/space/two_boxes.json --elements 4"},
      [options](Streams& streams) { return plan(*options, streams); });
  command.add_option("SCENE", options->scene, "the scene file")->required();
  options->elements.add_to(command);
  options->polygons.add_to(command);
  command.add_option("--grid", options->grid, "cells of the illumination, as solve would be asked for them")
      ->type_name("NXxNY");
  command.add_flag("--json", options->json, "as one JSON object");
}

}  // namespace hottel

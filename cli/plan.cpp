// hottel plan: what solve would simulate of a scene, and what not.
#include "cli/command.h"
#include "cli/scene_input.h"
#include "io/results/solve_report.h"
#include "io/scene/scene_json.h"
#include "solver/plane/simulation/simulation.h"

namespace hottel {
namespace {

struct PlanOptions {
  std::string scene, grid;
  ElementOptions elements;
  bool json = false;
};

ExitCode plan(const PlanOptions& options, Streams& streams) {
  Scene2 scene = read_scene_2(options.scene);
  options.elements.apply_to(scene);
  const Grid2 grid = grid_of(scene, options.grid);
  const auto plan = Simulation2(std::move(scene), {.grid = grid}).plan();
  streams.write("", options.json ? plan_json(options.scene, *plan) : plan_text(*plan));
  return ExitCode::kDone;
}

}  // namespace

void add_plan(Commands& commands) {
  const auto options = std::make_shared<PlanOptions>();
  CLI::App& command = commands.add(
      "plan", "What solve would simulate, what not, why, and what it costs",
      {"hottel plan scenes/showcase/apartment.json", "hottel plan scenes/analytic/square_radiosity.json --json"},
      [options](Streams& streams) { return plan(*options, streams); });
  command.add_option("SCENE", options->scene, "the scene file")->required();
  options->elements.add_to(command);
  command.add_option("--grid", options->grid, "cells of the illumination, as solve would be asked for them")
      ->type_name("NXxNY");
  command.add_flag("--json", options->json, "as one JSON object");
}

}  // namespace hottel

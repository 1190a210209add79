// hottel plan: what solve would simulate of a scene, and what not.
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "cli/command.h"
#include "cli/machine_speed.h"
#include "cli/room_for_elements.h"
#include "cli/scene_input.h"
#include "cli/sky_option.h"
#include "cli/sums_option.h"
#include "cli/volume_files.h"
#include "geometry/plane/exchange/exchange_sums.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/scene_names.h"
#include "io/files/disk_space.h"
#include "io/results/planned_nodes.h"
#include "io/results/solve_report.h"
#include "io/scene/scene_json.h"
#include "io/sums/plane/exact_on_disk.h"
#include "kernel/support/failure.h"
#include "solver/plan_speed.h"
#include "solver/plane/light/light_values.h"
#include "solver/plane/scene_plan.h"
#include "solver/plane/simulation/simulation.h"
#include "solver/space/simulation/simulation.h"
#include "viewer/picture/space/texels.h"

namespace hottel {
namespace {

struct PlanOptions {
  std::string scene, grid, illumination = "point", shading = "flat", texels;
  ElementOptions elements;
  PolygonOptions polygons;
  SkyOption sky;
  SumsOption sums;
  std::optional<std::uint64_t> memory;
  std::optional<int> nodes, cores;
  bool json = false;
};

// What is planned: how much memory, where that was asked for or does not suffice, and the effects, unless the machine
// cannot hold what they come from.
struct Planned {
  std::shared_ptr<const Plan> effects;
  std::optional<PlannedMemory> memory;
  // In the plane, beside the memory; seconds of one core, those of the second what the disk adds.
  std::optional<PlannedLists> lists;
  std::optional<PlannedOnDisk> on_disk;
  double preparing = 0;  // in the plane: seconds of one core that every process takes for itself
};

// cells: of the grid.
template <class AnyScene>
std::optional<PlannedMemory> memory_of(const PlanOptions& options, const AnyScene& scene, std::uint64_t cells) {
  MemoryQuestion question = solving_question(scene);
  question.cells = cells;
  question.pairs_on_disk = options.sums.is_given();
  const bool is_asked = options.memory || question.pairs_on_disk || options.nodes;
  if (!is_asked && !is_divided(scene)) return std::nullopt;
  const MemoryLimits limits = memory_limits(options.memory.value_or(0));
  const double room = is_asked ? 0 : static_cast<double>(limits.of_all);
  MemoryEstimate estimate = estimate_memory(scene, question, room);
  std::string problem = memory_problem(estimate, limits);
  if (!is_asked && problem.empty()) return std::nullopt;
  return PlannedMemory{std::move(estimate), limits, std::move(problem)};
}

// Whether the machine holds what was estimated, whatever is allowed.
bool is_had(const std::optional<PlannedMemory>& memory) {
  return !memory || memory_problem(memory->estimate, {memory->limits.of_all, memory->limits.of_all}).empty();
}

PlannedLists lists_of(double pairs, const std::string& unit, double vertices) {
  return planned_lists(pairs, unit, seconds_of_factors_2(vertices, pairs),
                       pairs * static_cast<double>(kBytesOfSumOnDisk));
}
// The number of pairs is an estimate: from the views of some vertices, or, without an arrangement, as the memory is.
PlannedLists lists_of(const Simulation2& simulation, const MemoryEstimate& memory, bool is_arranged) {
  if (!is_arranged) {
    const MemoryStage& stage = memory.stages()[1];
    return lists_of(stage.count, stage.unit, 2 * memory.stages()[0].count);
  }
  const auto prepared = simulation.prepared();
  const auto pairs =
      static_cast<double>(estimated_sight(prepared->arrangement, *prepared->elements(simulation.granularity())).pairs);
  const auto vertices = static_cast<double>(prepared->arrangement.vertices().size());
  return lists_of(pairs, "visible pairs", vertices);
}

PlannedOnDisk on_disk_of(const PlanOptions& options, const Scene2& scene, double pairs) {
  const auto memory = static_cast<double>(memory_limits(options.memory.value_or(0)).of_factors);
  const std::filesystem::path folder = options.sums.folder();
  const bool stays = options.sums.request().stays;
  return {.option = options.sums.name(),
          .folder = folder.string(),
          .pairs = pairs,
          .memory_bytes = memory_beside_disk(scene, pairs, memory),
          .disk_bytes = static_cast<double>(disk_for_radiosities_2(static_cast<std::uint64_t>(pairs), stays)),
          .free = free_space(folder / "sums"),
          .seconds = seconds_on_disk_2(pairs)};
}

// What of light is asked for in space.
PlanRequest light_of(const PlanOptions& options, const Scene3& scene, std::uint64_t cells) {
  PlanRequest request{.grid_cells = cells,
                      .is_average = options.illumination == "average",
                      .is_gathered = options.shading == "gathered"};
  if (options.illumination == "inverse-square") throw UsageError("--illumination inverse-square is for the plane");
  if (options.illumination != PlanOptions().illumination && cells == 0)
    throw UsageError("--illumination is for light on a grid, and " + options.scene + " has none");
  refuse_averages_in_volumes(options.illumination, scene);
  if (options.texels.empty()) return request;
  const TexelOption asked = texel_option(options.texels);
  request.texels = texel_grid_3(scene, face_of(scene, asked.name), asked.nu, asked.nv).cells();
  return request;
}

Planned plan_of(const PlanOptions& options, ValidScene2 scene) {
  options.sky.refuse_in_plane();
  for (const auto& [is_given, option] :
       {std::pair(options.shading != PlanOptions().shading, "--shading"), {!options.texels.empty(), "--texels"}})
    if (is_given) throw UsageError(std::string(option) + " is only for scenes in space");
  options.elements.apply_to(scene);
  scene.set_grids(grids_of(*scene, options.grid));
  Planned result{nullptr, memory_of(options, *scene, cells_of(scene->grids)), {}, {}, 0};
  const Simulation2 simulation(std::move(scene), {.light = *light_kind_2(options.illumination)});
  if (is_had(result.memory)) result.effects = simulation.plan();
  if (result.memory) result.lists = lists_of(simulation, result.memory->estimate, result.effects != nullptr);
  if (options.nodes && result.effects)
    result.preparing =
        seconds_of_factors_2(static_cast<double>(simulation.prepared()->arrangement.vertices().size()), 0);
  if (options.sums.is_given() && result.effects)
    result.on_disk = on_disk_of(options, simulation.scene(), result.lists->pairs);
  return result;
}

Planned plan_of(const PlanOptions& options, ValidScene3 scene) {
  if (options.sums.is_given()) throw UsageError(std::string(options.sums.name()) + " is for scenes in the plane");
  options.elements.apply_to(scene);
  const std::uint64_t cells = cells_of(grids_of(*scene, options.grid));
  Planned result{nullptr, memory_of(options, *scene, cells), {}, {}, 0};
  const PlanRequest light = light_of(options, *scene, cells);
  if (is_had(result.memory))
    result.effects = Simulation3(std::move(scene), {.factors = {.sky = options.sky.in_space()}, .plan = light}).plan();
  return result;
}

void refuse_nodes(const PlanOptions& options) {
  if (options.cores && !options.nodes) throw UsageError("--cores are those of each node: say how many with --nodes");
  if (options.nodes && options.sums.is_given())
    throw UsageError("--nodes tells nothing of " + std::string(options.sums.name()) +
                     ": what stands in files is computed by one process");
}

// Where nothing is said of the cores, they are those of this machine.
PlannedNodes nodes_of(const PlanOptions& options, const Planned& planned, const MachineSpeed& speed) {
  const Nodes nodes{.count = *options.nodes,
                    .cores = options.cores.value_or(speed.threads),
                    .memory = static_cast<double>(planned.memory->limits.of_factors)};
  return planned_nodes(planned.effects.get(), planned.preparing, speed.slowness, planned.memory->estimate, nodes);
}

ExitCode plan(const PlanOptions& options, Streams& streams) {
  refuse_nodes(options);
  Planned planned = std::visit([&](auto&& scene) { return plan_of(options, std::move(scene)); },
                               read_scene_noting(options.scene, options.polygons, streams));
  const MachineSpeed speed = planned.effects || planned.lists || options.nodes ? machine_speed() : MachineSpeed();
  std::optional<PlannedNodes> nodes;
  if (options.nodes) nodes = nodes_of(options, planned, speed);
  std::optional<Plan> here;
  if (planned.effects) here = plan_at_speed(*planned.effects, speed);
  if (planned.lists) planned.lists->seconds = shared_seconds(planned.lists->seconds, speed);
  if (planned.on_disk) {
    planned.on_disk->seconds = shared_seconds(planned.on_disk->seconds, speed);
    for (const PlannedEffect& effect : here->effects()) planned.on_disk->seconds += effect.seconds_estimate;
  }
  const Plan* const effects = here ? &*here : nullptr;
  const PlannedMemory* const memory = planned.memory ? &*planned.memory : nullptr;
  const PlannedLists* const lists = planned.lists ? &*planned.lists : nullptr;
  const PlannedOnDisk* const on_disk = planned.on_disk ? &*planned.on_disk : nullptr;
  std::string told = options.json ? plan_json(options.scene, effects, memory, lists, on_disk)
                                  : plan_text(effects, memory, lists, on_disk);
  if (nodes) told = options.json ? with_nodes(told, *nodes) : told + nodes_text(*nodes);
  streams.write("", told);
  return ExitCode::kDone;
}

}  // namespace

void add_plan(Commands& commands) {
  const auto options = std::make_shared<PlanOptions>();
  CLI::App& command = commands.add(
      "plan", "What solve would simulate, what not, why, and what it costs",
      {"hottel plan scenes/showcase/apartment.json", "hottel plan scenes/analytic/square_radiosity.json --json",
       "hottel plan scenes/space/two_boxes.json --elements 4",
       "hottel plan scenes/space/two_boxes.json --elements 1000 --memory 8000000000",
       "hottel plan scenes/showcase/apartment.json --elements 100 --out-of-core /tmp",
       "hottel plan scenes/space/two_boxes.json --elements 8 --nodes 4 --cores 64 --memory 256000000000"},
      [options](Streams& streams) { return plan(*options, streams); });
  command.add_option("SCENE", options->scene, "the scene file")->required();
  options->elements.add_to(command);
  options->polygons.add_to(command);
  options->sky.add_to(command);
  command.add_option("--grid", options->grid, "cells of the illumination, as solve would be asked for them")
      ->type_name("NXxNY");
  command
      .add_option("--illumination", options->illumination,
                  "how the light in cells is found, as solve would be asked for it: point, average or inverse-square")
      ->check(CLI::IsMember({"point", "average", "inverse-square"}))
      ->capture_default_str();
  command
      .add_option("--shading", options->shading,
                  "in space, how values run in the picture, as solve would be asked for it: flat, smooth or gathered")
      ->check(CLI::IsMember({"flat", "smooth", "gathered"}))
      ->capture_default_str();
  command.add_option("--texels", options->texels, "in space, a face and its texels, as solve would be asked for them")
      ->type_name("NAME=NXxNY");
  options->sums.add_to(
      command, "in the plane: tell what memory, disk and time solve takes with view factors in files of this folder",
      "the same, where the files stay when a run is ended");
  command
      .add_option(
          "--memory", options->memory,
          "tell what each stage takes of memory, in the plane also what lists of factors take of disk, and whether it "
          "fits: elements and factors into so many bytes, "
          "all into the machine. Nothing is made of what does not fit the machine")
      ->type_name("BYTES")
      ->transform(whole_number(1));
  command
      .add_option("--nodes", options->nodes,
                  "tell what hottel-mpi would take on so many machines, one process each, by a model: seconds, the "
                  "memory of each (--memory, or as this machine has), and the least number of them")
      ->type_name("N")
      ->transform(whole_number(1));
  command.add_option("--cores", options->cores, "cores of each of the nodes; without it as many as here")
      ->type_name("N")
      ->transform(whole_number(1));
  command.add_flag("--json", options->json, "as one JSON object");
}

}  // namespace hottel

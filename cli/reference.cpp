// hottel reference: a folder of scenes with their exact solutions, which others can cite and test against.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "cli/command.h"
#include "cli/guarantee_option.h"
#include "cli/room_for_elements.h"
#include "cli/scene_input.h"
#include "cli/unit_notes.h"
#include "geometry/plane/prepared/element_pieces.h"
#include "geometry/space/exchange/written_outlines.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "io/files/output_file.h"
#include "io/files/text_file.h"
#include "io/results/grid_file.h"
#include "io/results/npy.h"
#include "io/results/plane/light_region.h"
#include "io/results/reference_set.h"
#include "io/results/space/element_files.h"
#include "io/results/space/factors_report.h"
#include "io/results/space/light_region.h"
#include "io/scene/scene_json.h"
#include "kernel/support/counted.h"
#include "kernel/support/failure.h"
#include "kernel/support/with_file_context.h"
#include "solver/plane/simulation/simulation.h"
#include "solver/space/light/illumination_grid.h"
#include "solver/space/simulation/simulation.h"

namespace hottel {
namespace {

struct ReferenceOptions {
  std::string directory;
  std::vector<std::string> scenes;
  std::optional<std::string> tolerance;
  GuaranteeOption guarantee;
  PolygonOptions polygons;
  ElementOptions elements;
  std::string grid;

  // Whether a scene is to be another than its file says.
  bool changes_scenes() const { return elements.is_given() || !grid.empty(); }
};

// What factors of a set in space may be off, where nothing is said: less than others are likely to ask for.
constexpr double kTolerance = 1e-12;

// A scene, and the text of a scene file that by itself holds it.
struct GivenScene {
  ValidScene scene;
  std::string text;
};

// Reads a scene. Returns whether its file by itself holds it.
bool read_given(const std::string& file, const ReferenceOptions& options, const Streams& streams, GivenScene& given) {
  if (std::filesystem::path(file).extension() != ".json") {
    given.scene = read_scene_noting(file, options.polygons, streams);
    return false;
  }
  bool names_files = false;
  given.text = read_text_file(file);
  given.scene = parse_scene(given.text, file, [&](const std::filesystem::path& mesh) {
    names_files = true;
    return read_text_file(mesh);
  });
  return !names_files;
}

// Divides a scene, and its grids, as asked for.
template <class AnyValidScene>
void change(const ReferenceOptions& options, AnyValidScene& scene) {
  options.elements.apply_to(scene);
  if (!options.grid.empty()) scene.set_grids(grids_of(*scene, options.grid));
}

std::string text_of(const std::string& file, const ValidScene& scene) {
  return with_file_context(file, [&] {
    const auto* const plane = std::get_if<ValidScene2>(&scene);
    return plane != nullptr ? write_scene_2(**plane) : write_scene_3(*std::get<ValidScene3>(scene));
  });
}

// Maps and drawings become polylines, meshes and decks polygons; divided scenes say so.
GivenScene given_scene(const std::string& file, const ReferenceOptions& options, const Streams& streams) {
  options.polygons.require_sense_for(file);
  GivenScene given;
  if (read_given(file, options, streams, given) && !options.changes_scenes()) return given;
  std::visit([&](auto& scene) { change(options, scene); }, given.scene);
  given.text = text_of(file, given.scene);
  try {
    given.scene = parse_scene(given.text, file);
  } catch (const InputError& error) {
    throw RequestError(
        file + ": as a scene file by itself, which `hottel convert` writes, it cannot be read: " + error.what());
  }
  return given;
}

// Light on each grid of a scene.
std::vector<std::shared_ptr<const SolvedLight2>> lights_of(const Simulation2& simulation, const Streams& streams) {
  std::vector<std::shared_ptr<const SolvedLight2>> lights;
  for (const Grid2& grid : simulation.scene().grids) {
    SimulationRequest2 request = simulation.request();
    request.grid = grid;
    lights.push_back(simulation.with_request(request).light(streams.stages()));
  }
  return lights;
}

std::vector<std::shared_ptr<const IlluminationGrid3>> lights_of(const Simulation3& simulation, const Streams& streams) {
  std::vector<std::shared_ptr<const IlluminationGrid3>> lights;
  for (const Grid3& grid : simulation.scene().grids) {
    SimulationRequest3 request = simulation.request();
    request.light.grid = grid;
    lights.push_back(simulation.with_request(request).light(streams.stages()));
  }
  return lights;
}

std::vector<ReferenceLight> reference_lights(const std::vector<std::shared_ptr<const SolvedLight2>>& lights,
                                             const RadiositySolution& solution) {
  std::vector<ReferenceLight> result;
  for (const auto& light : lights) {
    const IlluminationGrid2& cells = light->grid;
    result.push_back({grid_file("illumination", cells.grid.name),
                      {cells.grid.ny, cells.grid.nx, cells.channels},
                      cells.values,
                      illumination_sidecar(region_of(cells.grid), solution.channel_names, "point")});
  }
  return result;
}

std::vector<ReferenceLight> reference_lights(const std::vector<std::shared_ptr<const IlluminationGrid3>>& lights,
                                             const RadiositySolution& solution) {
  std::vector<ReferenceLight> result;
  for (const auto& light : lights) {
    std::vector<std::size_t> shape = array_shape(light->grid);
    shape.push_back(light->channels);
    result.push_back({grid_file("illumination", light->grid.name), std::move(shape), light->values,
                      illumination_sidecar(region_of(light->grid), solution.channel_names)});
  }
  return result;
}

SceneReference refer_in_plane(const std::string& name, GivenScene given, const Streams& streams) {
  const Simulation2 simulation(std::get<ValidScene2>(std::move(given.scene)),
                               {.granularity = Granularity::kElement, .wants_visibility = true});
  const auto factors = simulation.factors(streams.stages());
  const auto solution = simulation.radiosities(streams.stages());
  const auto lights = lights_of(simulation, streams);
  const Scene2& scene = simulation.scene();
  const FactorTable table{scene, factors->matrix, Granularity::kElement};
  return scene_reference(name, reference_units_2(scene), std::move(given.text),
                         {.scene = scene,
                          .matrix = factors->matrix,
                          .solution = *solution,
                          .counts = factor_counts(factors->report.counts),
                          .write_faces =
                              [&](const Sink& sink) {
                                write_faces_csv(table, element_pieces(*simulation.prepared(), Granularity::kElement),
                                                sink);
                              },
                          .lights = reference_lights(lights, *solution)});
}

SceneReference refer_in_space(const std::string& name, GivenScene given, double tolerance, bool must_be_enclosed,
                              const Streams& streams) {
  const Simulation3 simulation(std::get<ValidScene3>(std::move(given.scene)),
                               {.factors = {.granularity = Granularity::kElement,
                                            .wants_visibility = true,
                                            .tolerance = tolerance,
                                            .must_be_enclosed = must_be_enclosed}});
  const auto prepared = simulation.prepared();
  const auto factors = simulation.factors(streams.stages());
  const auto solution = simulation.radiosities(streams.stages());
  const auto lights = lights_of(simulation, streams);
  const FactorTable table{prepared->scene, factors->matrix, Granularity::kElement};
  return scene_reference(name, reference_units_3(prepared->scene), std::move(given.text),
                         {.scene = prepared->scene,
                          .matrix = factors->matrix,
                          .solution = *solution,
                          .counts = factor_counts(factors->report),
                          .max_defect = factors->report.max_defect,
                          .tolerance = tolerance,
                          .write_faces =
                              [&](const Sink& sink) {
                                const ElementTable3& elements = *prepared->elements(Granularity::kElement);
                                write_faces_csv_3(table, written_outlines(elements, prepared->occluders().vertices()),
                                                  sink);
                              },
                          .lights = reference_lights(lights, *solution)});
}

// The factors of all elements and the radiosities of one scene.
SceneReference refer(const ReferenceOptions& options, const std::string& name, GivenScene given,
                     const Streams& streams) {
  std::visit([](const auto& scene) { require_room_for_solving(*scene, std::nullopt); }, given.scene);
  require_light_in_watts(given.scene);
  note_unknown_unit(given.scene, streams);
  if (std::holds_alternative<ValidScene2>(given.scene)) return refer_in_plane(name, std::move(given), streams);
  return refer_in_space(name, std::move(given), tolerance_of(options.tolerance, kTolerance),
                        options.guarantee.must_be_enclosed(), streams);
}

std::vector<GivenScene> given_scenes(const ReferenceOptions& options, const Streams& streams) {
  std::vector<GivenScene> scenes;
  for (const std::string& file : options.scenes) scenes.push_back(given_scene(file, options, streams));
  return scenes;
}

// Throws UsageError where an option for scenes in space is given and no scene of the set is in space.
void require_some_in_space(const ReferenceOptions& options, const std::vector<GivenScene>& scenes) {
  if (std::ranges::any_of(scenes,
                          [](const GivenScene& given) { return std::holds_alternative<ValidScene3>(given.scene); }))
    return;
  if (options.tolerance)
    throw UsageError("--tolerance is for scenes in space: in the plane, as " + options.scenes.front() +
                     " is, every factor is correctly rounded");
  options.guarantee.refuse_in_plane();
}

// What was asked of all scenes together, as it is typed: the scenes of the set say the rest.
std::string said_of_factors(const ReferenceOptions& options) {
  std::string said;
  if (options.tolerance) said += " --tolerance " + *options.tolerance;
  if (options.guarantee.asked) said += " --guarantee " + *options.guarantee.asked;
  return said;
}

// The name of a scene in the set: of its file, or of the folder of a scene.json.
std::string name_of(const std::string& file) {
  const std::filesystem::path path = std::filesystem::absolute(file).lexically_normal();
  return path.filename() == "scene.json" ? path.parent_path().filename().string() : path.stem().string();
}

ExitCode reference(const ReferenceOptions& options, Streams& streams) {
  if (options.directory == "-") throw UsageError("a set is a folder of files, not standard output");
  std::set<std::string> names;
  for (const std::string& file : options.scenes)
    if (!names.insert(name_of(file)).second)
      throw UsageError("two scenes are called '" + name_of(file) + "': names of scenes in a set must differ");

  std::vector<GivenScene> given = given_scenes(options, streams);
  require_some_in_space(options, given);
  const std::filesystem::path directory = options.directory;
  const OutputFolder whole(directory);  // before the work
  std::vector<SceneReference> scenes;
  for (std::size_t k = 0; k < given.size(); ++k) {
    const SceneReference& scene =
        scenes.emplace_back(refer(options, name_of(options.scenes[k]), std::move(given[k]), streams));
    streams.note(
        fmt::format("{}: {}, {}, {}; discrete radiosities of these elements {}, bounds within {:.1e} of the value",
                    scene.name, counted(scene.counts.elements, "element"), counted(scene.factors, "factor"),
                    to_string(scene.of_factors), to_string(scene.of_radiosities), scene.max_relative_width));
  }
  const std::vector<SetFile> files = set_files(std::move(scenes), said_of_factors(options));

  std::vector<OutputFolder> folders;
  std::vector<OutputFile> outputs;
  for (const SetFile& file : files) {
    folders.emplace_back((directory / file.path).parent_path());
    outputs.emplace_back(directory / file.path).write(file.text);
  }
  // All files are whole before the first one takes its name.
  for (OutputFile& output : outputs) output.finish();
  for (OutputFile& output : outputs) output.commit();
  streams.note(fmt::format("{} files in {}", files.size(), directory.string()));
  return ExitCode::kDone;
}

}  // namespace

void add_reference(Commands& commands) {
  const auto options = std::make_shared<ReferenceOptions>();
  CLI::App& command = commands.add(
      "reference",
      "Write a set of reference solutions: scenes, factors, radiosities of their elements (a discrete problem) with "
      "bounds, light on "
      "their grids, checksums",
      {"hottel reference /tmp/set scenes/showcase/apartment.json scenes/analytic/square_radiosity.json --grid 32x24",
       "hottel reference /tmp/squares scenes/analytic/square_radiosity.json --elements 8",
       "hottel reference /tmp/rooms scenes/space/two_boxes.json scenes/space/cube.json",
       "hottel compare /tmp/set/square_radiosity/scene.json --methods file:/tmp/set/square_radiosity/factors.csv "
       "-o /tmp/compared"},
      [options](Streams& streams) { return reference(*options, streams); });
  command.add_option("DIR", options->directory, "the folder to write into, created")->required();
  command.add_option("SCENES", options->scenes, "scene files; scene.json is named after its folder")->required();
  options->elements.add_to(command);
  command
      .add_option("--grid", options->grid,
                  "cells of the light, as solve takes them; without it light is of the scenes that have a grid")
      ->type_name("NXxNY");
  options->polygons.add_front_to(command);
  command
      .add_option("--tolerance", options->tolerance,
                  "in space: what A F may be off, relative to the smaller area (default 1e-12)")
      ->type_name("T");
  options->guarantee.add_to(command);
}

}  // namespace hottel

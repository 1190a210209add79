// hottel reference: a folder of scenes with their exact solutions, which others can cite and test against.
#include <fmt/format.h>

#include <filesystem>
#include <set>

#include "cli/command.h"
#include "cli/guarantee_option.h"
#include "cli/scene_input.h"
#include "cli/unit_notes.h"
#include "geometry/plane/prepared/element_pieces.h"
#include "geometry/space/exchange/written_outlines.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "io/files/output_file.h"
#include "io/files/text_file.h"
#include "io/results/reference_set.h"
#include "io/results/space/element_files.h"
#include "io/results/space/factors_report.h"
#include "io/scene/scene_json.h"
#include "kernel/support/counted.h"
#include "kernel/support/failure.h"
#include "kernel/support/naming_file.h"
#include "solver/plane/simulation/simulation.h"
#include "solver/space/simulation/simulation.h"

namespace hottel {
namespace {

struct ReferenceOptions {
  std::string directory;
  std::vector<std::string> scenes;
  std::optional<std::string> tolerance;
  GuaranteeOption guarantee;
  PolygonOptions polygons;
};

// What factors of a set in space may be off, where nothing is said: less than others are likely to ask for.
constexpr double kTolerance = 1e-12;

// A scene, and the text of a scene file that by itself holds it.
struct GivenScene {
  Scene scene;
  std::string text;
};

GivenScene given_scene(const std::string& file, const PolygonOptions& polygons, const Streams& streams) {
  polygons.require_sense_for(file);
  bool names_files = false;
  GivenScene given;
  if (std::filesystem::path(file).extension() == ".json") {
    given.text = read_text_file(file);
    given.scene = parse_scene(given.text, file, [&](const std::filesystem::path& mesh) {
      names_files = true;
      return read_text_file(mesh);
    });
    if (!names_files) return given;
  } else {
    given.scene = read_scene_noting(file, polygons, streams);
  }
  // Maps and drawings as polylines, meshes and decks as polygons, and what these come to when they are read.
  given.text = naming_file(file, [&] {
    const auto* const plane = std::get_if<Scene2>(&given.scene);
    return plane != nullptr ? write_scene_2(*plane) : write_scene_3(std::get<Scene3>(given.scene));
  });
  try {
    given.scene = parse_scene(given.text, file);
  } catch (const InputError& error) {
    throw RequestError(
        file + ": as a scene file by itself, which `hottel convert` writes, it cannot be read: " + error.what());
  }
  return given;
}

SceneReference refer_in_plane(const std::string& name, GivenScene given, const Streams& streams) {
  const Simulation2 simulation(std::get<Scene2>(std::move(given.scene)),
                               {.granularity = Granularity::kElement, .wants_visibility = true});
  const auto factors = simulation.factors(streams.stages());
  const auto solution = simulation.radiosities(streams.stages());
  const Scene2& scene = simulation.scene();
  const FactorTable table{scene, factors->matrix, Granularity::kElement};
  return scene_reference(name, std::move(given.text),
                         {.scene = scene,
                          .matrix = factors->matrix,
                          .solution = *solution,
                          .counts = factor_counts(factors->report.counts),
                          .write_faces = [&](const Sink& sink) {
                            write_faces_csv(table, element_pieces(*simulation.prepared(), Granularity::kElement), sink);
                          }});
}

SceneReference refer_in_space(const std::string& name, GivenScene given, double tolerance, bool must_be_enclosed,
                              const Streams& streams) {
  const Simulation3 simulation(std::get<Scene3>(std::move(given.scene)),
                               {.factors = {.granularity = Granularity::kElement,
                                            .wants_visibility = true,
                                            .tolerance = tolerance,
                                            .must_be_enclosed = must_be_enclosed}});
  const auto prepared = simulation.prepared();
  const auto factors = simulation.factors(streams.stages());
  const auto solution = simulation.radiosities(streams.stages());
  const FactorTable table{prepared->scene, factors->matrix, Granularity::kElement};
  return scene_reference(name, std::move(given.text),
                         {.scene = prepared->scene,
                          .matrix = factors->matrix,
                          .solution = *solution,
                          .counts = factor_counts(factors->report),
                          .max_defect = factors->report.max_defect,
                          .tolerance = tolerance,
                          .write_faces = [&](const Sink& sink) {
                            const ElementTable3& elements = *prepared->elements(Granularity::kElement);
                            write_faces_csv_3(table, written_outlines(elements, prepared->blockers().vertices()), sink);
                          }});
}

// The factors of all elements and the radiosities of one scene.
SceneReference refer(const ReferenceOptions& options, const std::string& file, const std::string& name,
                     const Streams& streams) {
  GivenScene given = given_scene(file, options.polygons, streams);
  require_light_in_watts(given.scene);
  note_unknown_unit(given.scene, streams);
  if (std::holds_alternative<Scene3>(given.scene))
    return refer_in_space(name, std::move(given), tolerance_of(options.tolerance, kTolerance),
                          options.guarantee.must_be_enclosed(), streams);
  if (options.tolerance)
    throw UsageError("--tolerance is for scenes in space: in the plane, as " + file +
                     " is, every factor is correctly rounded");
  options.guarantee.refuse_in_plane();
  return refer_in_plane(name, std::move(given), streams);
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

  std::vector<SceneReference> scenes;
  for (const std::string& file : options.scenes) {
    const SceneReference& scene = scenes.emplace_back(refer(options, file, name_of(file), streams));
    streams.note(fmt::format("{}: {}, {}, {}; radiosities of these elements {}, bounds within {:.1e} of the value",
                             scene.name, counted(scene.counts.elements, "element"), counted(scene.factors, "factor"),
                             to_string(scene.of_factors), to_string(scene.of_radiosities), scene.max_relative_width));
  }
  const std::vector<SetFile> files = set_files(std::move(scenes));

  const std::filesystem::path directory = options.directory;
  const OutputFolder whole(directory);
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
      "Write a set of reference solutions: scenes, factors, radiosities of their elements with bounds, checksums",
      {"hottel reference /tmp/set scenes/showcase/apartment.json scenes/analytic/square_radiosity.json",
       "hottel reference /tmp/rooms scenes/space/two_boxes.json scenes/space/cube.json",
       "hottel compare /tmp/set/square_radiosity/scene.json --methods file:/tmp/set/square_radiosity/factors.csv "
       "-o /tmp/compared"},
      [options](Streams& streams) { return reference(*options, streams); });
  command.add_option("DIR", options->directory, "the folder to write into, created")->required();
  command.add_option("SCENES", options->scenes, "scene files; scene.json is named after its folder")->required();
  options->polygons.add_front_to(command);
  command
      .add_option("--tolerance", options->tolerance,
                  "in space: what A F may be off, relative to the smaller area (default 1e-12)")
      ->type_name("T");
  options->guarantee.add_to(command);
}

}  // namespace hottel

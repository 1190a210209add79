// hottel reference: a folder of scenes with their exact solutions, which others can cite and test against.
#include <fmt/format.h>

#include <filesystem>
#include <set>

#include "cli/command.h"
#include "cli/scene_input.h"
#include "io/files/output_file.h"
#include "io/files/text_file.h"
#include "io/results/plane/reference_set.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "solver/plane/simulation/simulation.h"

namespace hottel {
namespace {

struct ReferenceOptions {
  std::string directory;
  std::vector<std::string> scenes;
};

// The factors of all elements and the radiosities of one scene.
SceneReference2 refer(const std::string& file, const std::string& name, const Streams& streams) {
  const Simulation2 simulation(read_scene_2(file), {.granularity = Granularity::kElement, .wants_visibility = true});
  const auto factors = simulation.factors(streams.stages());
  const auto solution = simulation.radiosities(streams.stages());
  return scene_reference(name, read_text_file(file), simulation.scene(), factors->matrix, factors->report.counts,
                         *solution);
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

  std::vector<SceneReference2> scenes;
  for (const std::string& file : options.scenes) {
    const SceneReference2& scene = scenes.emplace_back(refer(file, name_of(file), streams));
    streams.note(fmt::format("{}: {} elements, {} factors, bounds of radiosities within {:.1e} of the value",
                             scene.name, scene.exchange.elements, scene.factors, scene.max_relative_width));
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
      "reference", "Write a set of reference solutions: scenes, factors, radiosities with bounds, checksums",
      {"hottel reference /tmp/set scenes/showcase/apartment.json scenes/analytic/square_radiosity.json",
       "hottel compare /tmp/set/square_radiosity/scene.json --methods file:/tmp/set/square_radiosity/factors.csv "
       "-o /tmp/compared"},
      [options](Streams& streams) { return reference(*options, streams); });
  command.add_option("DIR", options->directory, "the folder to write into, created")->required();
  command.add_option("SCENES", options->scenes, "scene files; scene.json is named after its folder")->required();
}

}  // namespace hottel

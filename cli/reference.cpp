// hottel reference: a folder of scenes with their exact solutions, which others can cite and test against.
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "cli/command.h"
#include "cli/scene_input.h"
#include "geometry/plane/check/sight_findings.h"
#include "io/files/output_folder.h"
#include "io/files/text_file.h"
#include "io/results/factor_files.h"
#include "io/results/radiosity_files.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "kernel/support/memory.h"
#include "kernel/version.h"
#include "solver/radiosity/matrix_checks.h"
#include "solver/radiosity/radiosity.h"

namespace hottel {
namespace {

struct ReferenceOptions {
  std::string directory;
  std::vector<std::string> scenes;
};

// A file of the set, whole in memory: its path from the folder, and what it holds.
struct SetFile {
  std::string path, text;
};

struct SceneReference {
  std::string name;
  ExchangeReport exchange;
  std::uint64_t factors = 0;
  double max_relative_width = 0;
  std::vector<SetFile> files;
};

std::string written(const std::function<void(const Sink&)>& write) {
  std::string text;
  write([&text](std::string_view piece) { text += piece; });
  return text;
}

// The factors of all elements and the radiosities of one scene.
SceneReference refer(const std::string& file, const std::string& name, const Streams& streams) {
  SceneReference result;
  result.name = name;
  const PreparedScene2 prepared = prepare(read_scene_2(file), Divided::kYes);
  const ExchangeMatrix matrix = exact_exchange(prepared,
                                               {.granularity = Granularity::kElement,
                                                .memory = memory_allowed(),
                                                .progress = streams.progress("view factors of " + name)},
                                               &result.exchange);
  require_closed(prepared.scene, matrix);
  RadiosityOptions options;
  options.progress = streams.progress("radiosities of " + name);
  const Spectrum& sky = prepared.scene.sky_emission;
  const RadiositySolution solution = naming_file(file, [&] {
    RadiositySolution solved = solve_radiosity(matrix, prepared.scene.materials, sky, options);
    require_doubles(matrix, sky, solved);
    return solved;
  });
  result.factors = matrix.entry_count();
  result.max_relative_width = solution.max_relative_width;
  const FactorTable table{prepared.scene, matrix, Granularity::kElement, {}, {}};
  const std::string folder = name + "/";
  result.files.push_back({folder + "scene.json", read_text_file(file)});
  result.files.push_back({folder + "factors.csv", written([&](const Sink& sink) { write_factors_csv(table, sink); })});
  result.files.push_back({folder + "factors.mtx", written([&](const Sink& sink) { write_factors_mtx(table, sink); })});
  result.files.push_back(
      {folder + "factors.mtx.faces.csv", written([&](const Sink& sink) { write_faces_csv(table, sink); })});
  result.files.push_back({folder + "radiosity.csv", written([&](const Sink& sink) {
                            write_radiosity_csv(prepared.scene, matrix, solution, sink);
                          })});
  return result;
}

nlohmann::ordered_json manifest_entry(const SceneReference& scene) {
  nlohmann::ordered_json json;
  json["name"] = scene.name;
  json["counts"] = {{"surfaces", scene.exchange.surfaces},
                    {"elements", scene.exchange.elements},
                    {"vertices", scene.exchange.vertices},
                    {"pairs", scene.exchange.pairs},
                    {"factors", scene.factors}};
  json["factors"] = {{"guarantee", to_string(Guarantee::kExact)},
                     {"closure_is_exact", scene.exchange.closure_is_exact}};
  json["radiosities"] = {{"guarantee", to_string(Guarantee::kEnclosed)},
                         {"max_relative_width", scene.max_relative_width}};
  json["files"] = nlohmann::ordered_json::array();
  for (const SetFile& file : scene.files)
    json["files"].push_back({{"file", file.path}, {"bytes", file.text.size()}, {"sha256", sha256(file.text)}});
  return json;
}

constexpr const char* kReadme =
    R"(Reference solutions of diffuse light in the plane, computed by hottel {version}.

One folder a scene:

  scene.json              the scene, as it was given; coordinates are the decimals as typed
  factors.csv             view factors F(from, to) of all elements that see each other. Each is the double nearest to
                          the real number; it lies in [lower, upper]. Vis is the visible part (S / S0)
  factors.mtx             the same in Matrix Market's format; rows and columns as in the next file, the sky last
  factors.mtx.faces.csv   the elements: number, face, part, area, material, end points (front on the right of 0 -> 1)
  radiosity.csv           B, irradiance and net of each element and channel; the true B lies in [lower, upper], proven

reference.json says how many of each there are and what is guaranteed; SHA256SUMS holds the checksums of all files.

To check the files:             sha256sum -c SHA256SUMS
To judge your own factors:      hottel compare NAME/scene.json --methods file:YOUR_FACTORS.csv
To compute the set again:       hottel reference DIR NAME/scene.json    (scenes are named after their folder then)
To cite it: name hottel {version} and the checksum of SHA256SUMS. The same version writes the same bytes.
)";

std::string readme() {
  std::string text = kReadme;
  const std::string place = "{version}";
  for (std::size_t at = text.find(place); at != std::string::npos; at = text.find(place, at))
    text.replace(at, place.size(), kVersion);
  return text;
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

  nlohmann::ordered_json manifest;
  manifest["hottel"] = kVersion;
  manifest["scenes"] = nlohmann::ordered_json::array();
  std::vector<SetFile> files;
  for (const std::string& file : options.scenes) {
    SceneReference scene = refer(file, name_of(file), streams);
    manifest["scenes"].push_back(manifest_entry(scene));
    streams.note(fmt::format("{}: {} elements, {} factors, bounds of radiosities within {:.1e} of the value",
                             scene.name, scene.exchange.elements, scene.factors, scene.max_relative_width));
    std::move(scene.files.begin(), scene.files.end(), std::back_inserter(files));
  }
  files.push_back({"reference.json", manifest.dump(2) + "\n"});
  files.push_back({"README.txt", readme()});
  std::string sums;
  for (const SetFile& file : files) sums += sha256(file.text) + "  " + file.path + "\n";
  files.push_back({"SHA256SUMS", std::move(sums)});

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

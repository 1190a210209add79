// hottel check: what is worth telling about a scene before light is computed, and a repaired scene.
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command.h"
#include "cli/mesh_output.h"
#include "cli/scene_input.h"
#include "cli/streams.h"
#include "io/files/output_file.h"
#include "io/results/plane/check_report.h"
#include "io/results/space/check_report.h"
#include "io/scene/scene_json.h"
#include "io/scene/space/mesh_reader.h"
#include "kernel/support/failure.h"
#include "kernel/support/with_file_context.h"
#include "solver/plane/check/scene_repair.h"
#include "solver/plane/simulation/simulation.h"
#include "solver/space/check/scene_repair.h"
#include "solver/space/simulation/queries.h"
#include "solver/space/simulation/simulation.h"

namespace hottel {
namespace {

struct CheckCommandOptions {
  std::string scene, fix, within;
  PolygonOptions polygons;
  bool json = false;
};

// The file of a repaired scene, or its mesh: where it is that of the scene itself, written only if something was
// repaired, and told.
class RepairedFile {
 public:
  // Opens a scene file; the files of a mesh are opened when they are written. Throws OutputError.
  RepairedFile(const std::string& file, const std::filesystem::path& scene) : file_(file), mesh_(mesh_format_3(file)) {
    if (!mesh_) text_.emplace(file);
    is_input_ = is_same_file(file, scene);
  }

  // Writes a mesh, or holds the text of a scene file until commit().
  void write(const std::string& text, const Scene2&, bool is_repaired, const Streams&) {
    if (is_to_be_written(is_repaired)) hold(text);
  }
  void write(const std::string& text, const Scene3& scene, bool is_repaired, const Streams& streams) {
    if (!is_to_be_written(is_repaired)) return;
    if (mesh_)
      write_mesh(file_, *mesh_, scene, streams);
    else
      hold(text);
  }

  // Whether the scene stays as it is, where it would be overwritten by one that is not repaired.
  bool is_left() const { return is_input_ && !is_written_; }

  void commit(const Streams& streams) {
    if (is_written_ && text_) text_->commit();
    if (is_input_)
      streams.note(file_ +
                   (is_written_ ? " is overwritten by the repaired scene" : " is left as it is: nothing is repaired"));
  }

 private:
  bool is_to_be_written(bool is_repaired) { return is_written_ = !is_input_ || is_repaired; }
  void hold(const std::string& text) {
    text_->write(text);
    text_->finish();
  }

  std::string file_;
  std::optional<MeshFormat3> mesh_;
  std::optional<OutputFile> text_;  // of a scene file
  bool is_input_ = false, is_written_ = false;
};

// How far points may be moved; 0: not at all.
Rational distance_of(const CheckCommandOptions& options) {
  if (options.fix.empty() && !options.within.empty()) throw UsageError("--within D goes with --fix OUT");
  if (options.fix == "-") throw UsageError("--fix writes a scene file; standard output has the findings");
  if (!options.fix.empty() && !mesh_format_3(options.fix)) require_scene_ending("--fix", options.fix);
  if (options.within.empty()) return 0;
  const auto distance = parse_rational(options.within);
  if (!distance || *distance <= 0) throw UsageError("--within must be a positive number, not '" + options.within + "'");
  return *distance;
}

// ---- What each dimension does in its own way.

std::shared_ptr<const SceneCheck2> look_at(const ValidScene2& scene, const Streams& streams) {
  return Simulation2(scene).check(streams.stages());
}
std::shared_ptr<const SceneCheck3> look_at(const ValidScene3& scene, const Streams& streams) {
  return std::make_shared<const SceneCheck3>(scene_check(Simulation3(scene), streams.stages()));
}

std::string text_of(const Scene2& scene) { return write_scene_2(scene); }
std::string text_of(const Scene3& scene) { return write_scene_3(scene); }

// A repaired scene as its text is read back. `before`: the scene that is repaired.
ValidScene2 read_back(const std::string& text, const CheckCommandOptions& options, const Scene2&) {
  return parse_scene_2(text, options.fix);
}
ValidScene3 read_back(const std::string& text, const CheckCommandOptions& options, const Scene3& before) {
  Scene3 written = parse_scene_3(text, options.fix);
  written.sources = before.sources;
  if (mesh_format_3(options.fix))
    for (Surface& surface : written.surfaces) surface.line = 0;  // of a scene file that nobody gets
  return written;
}

template <class LookAtWritten>
Repair2 repaired(const ValidScene2& scene, const Rational& distance, const SceneCheck2& before,
                 const LookAtWritten& look_at_written, const Streams& streams) {
  return repair_scene(*scene, distance, before,
                      {[&](const Scene2& some) { return look_at(some, streams); }, look_at_written});
}
template <class LookAtWritten>
Repair3 repaired(const ValidScene3& scene, const Rational& distance, const SceneCheck3& before,
                 const LookAtWritten& look_at_written, const Streams&) {
  return repair_scene(*scene, distance, before, [&](const Scene3& some) { return *look_at_written(some); });
}

// ---- What both do alike.

template <class Check>
ExitCode exit_code(const Check& check) {
  return has_error(check.findings) ? ExitCode::kUnmet : ExitCode::kDone;
}

// Writes the repaired scene, and tells what was done and what is found in it.
template <class Valid>
ExitCode fix(const CheckCommandOptions& options, const Rational& distance, const Valid& scene, Streams& streams) {
  RepairedFile out(options.fix, options.scene);
  const auto before = look_at(scene, streams);
  std::string text;
  Valid written;
  auto after = before;
  const auto look_at_written = [&](const auto& some) {
    text = with_file_context(options.scene, [&] { return text_of(some); });
    written = read_back(text, options, *scene);
    return after = look_at(written, streams);
  };
  const auto repair = repaired(scene, distance, *before, look_at_written, streams);

  std::optional<std::vector<FactorChange>> changes;
  if (before->factors && after->factors)
    changes = factor_changes(*before->factors, *after->factors,
                             [&](const Element& element) { return former_name(repair, element); });
  const RepairReport report{&repair.steps, changes ? &*changes : nullptr};
  with_file_context(options.scene, [&] { out.write(text, *written, is_anything_done(repair.steps), streams); });
  const auto& told = out.is_left() ? *scene : *written;  // of the file that is there, its lines
  const auto& found = out.is_left() ? *before : *after;
  streams.write("", options.json ? check_json(told, found.findings, &report)
                                 : repair_text(*scene, report) + check_text(told, found.findings));
  out.commit(streams);
  return exit_code(found);
}

template <class Valid>
ExitCode check_scene(const CheckCommandOptions& options, const Rational& distance, const Valid& scene,
                     Streams& streams) {
  if (!options.fix.empty()) return fix(options, distance, scene, streams);
  const auto check = look_at(scene, streams);
  streams.write("", options.json ? check_json(*scene, check->findings) : check_text(*scene, check->findings));
  return exit_code(*check);
}

ExitCode check(const CheckCommandOptions& options, Streams& streams) {
  const Rational distance = distance_of(options);
  const ValidScene scene = read_scene_noting(options.scene, options.polygons, streams);
  if (std::holds_alternative<ValidScene2>(scene) && mesh_format_3(options.fix))
    throw UsageError("a scene in the plane is repaired as a scene (.json), not as a mesh");
  return std::visit([&](const auto& its) { return check_scene(options, distance, its, streams); }, scene);
}

}  // namespace

void add_check(Commands& commands) {
  const auto options = std::make_shared<CheckCommandOptions>();
  CLI::App& command = commands.add(
      "check", "Find what is wrong with a scene, probably not meant, or worth knowing",
      {"hottel check scenes/showcase/apartment.json", "hottel check scenes/analytic/triangle_345.json --json",
       "hottel check scenes/showcase/maze.json --fix /tmp/maze.json --within 1e-6",
       "hottel check scenes/space/room_six_digits.json --fix /tmp/room.json --within 1e-5"},
      [options](Streams& streams) { return check(*options, streams); });
  command.add_option("SCENE", options->scene, "the scene file")->required();
  command.add_flag("--json", options->json, "as one JSON object");
  options->polygons.add_to(command);
  command
      .add_option(
          "--fix", options->fix,
          "write a repaired scene (in space a mesh too): rooms, bodies and polygons that are inside out or upside down "
          "reversed, doubles dropped, \"behind\": \"solid\" "
          "said where "
          "that is certain, with --within also near misses closed and repetitions dropped; then the repairs, "
          "the change in every "
          "affected view factor and what is found in the repaired scene are shown")
      ->type_name("OUT");
  command
      .add_option("--within", options->within,
                  "how far --fix may move a point, in units of the scene; without it not at all")
      ->type_name("D");
}

}  // namespace hottel

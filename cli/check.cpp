// hottel check: what is worth telling about a scene before light is computed, and a repaired scene.
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
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

// The file of a repaired scene: where it is that of the scene itself, written only if something was repaired, and told.
class RepairedFile {
 public:
  // Opens it. Throws OutputError.
  RepairedFile(const std::string& file, const std::filesystem::path& scene) : file_(file), out_(file) {
    std::error_code missing;
    is_input_ = std::filesystem::equivalent(file, scene, missing) && !missing;
  }

  // Holds the text until commit().
  void write(std::string_view text, bool is_repaired) {
    is_written_ = !is_input_ || is_repaired;
    if (!is_written_) return;
    out_.write(text);
    out_.finish();
  }

  // Whether the scene stays as it is, where it would be overwritten by one that is not repaired.
  bool is_left() const { return is_input_ && !is_written_; }

  void commit(const Streams& streams) {
    if (is_written_) out_.commit();
    if (is_input_)
      streams.note(file_ +
                   (is_written_ ? " is overwritten by the repaired scene" : " is left as it is: nothing is repaired"));
  }

 private:
  std::string file_;
  OutputFile out_;
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

std::shared_ptr<const SceneCheck2> look_at(const ValidScene2& scene, const Streams& streams) {
  return Simulation2(scene).check(streams.stages());
}

ExitCode exit_code(const SceneCheck2& check) { return has_error(check.findings) ? ExitCode::kUnmet : ExitCode::kDone; }

// Writes the repaired scene, and tells what was done and what is found in it.
ExitCode fix(const CheckCommandOptions& options, const Rational& distance, const ValidScene2& scene, Streams& streams) {
  RepairedFile out(options.fix, options.scene);
  const auto before = look_at(scene, streams);
  std::string text;
  ValidScene2 repaired;
  std::shared_ptr<const SceneCheck2> after;
  const auto look = [&](const Scene2& some) { return look_at(some, streams); };
  const auto look_at_written = [&](const Scene2& some) {
    text = with_file_context(options.scene, [&] { return write_scene_2(some); });
    repaired = parse_scene_2(text, options.fix);
    return after = look_at(repaired, streams);
  };
  const Repair2 repair = repair_scene(*scene, distance, *before, {look, look_at_written});

  std::optional<std::vector<FactorChange>> changes;
  if (before->factors && after->factors)
    changes = factor_changes(*before->factors, *after->factors,
                             [&](const Element& element) { return former_name(repair, element); });
  const RepairReport report{&repair.steps, changes ? &*changes : nullptr};
  out.write(text, is_anything_done(repair.steps));
  const Scene2& told = out.is_left() ? *scene : *repaired;  // of the file that is there, its lines
  const SceneCheck2& found = out.is_left() ? *before : *after;
  streams.write("", options.json ? check_json(told, found.findings, &report)
                                 : repair_text(*scene, report) + check_text(told, found.findings));
  out.commit(streams);
  return exit_code(found);
}

ExitCode check_in_plane(const CheckCommandOptions& options, const Rational& distance, const ValidScene2& scene,
                        Streams& streams) {
  if (mesh_format_3(options.fix))
    throw UsageError("a scene in the plane is repaired as a scene (.json), not as a mesh");
  if (!options.fix.empty()) return fix(options, distance, scene, streams);
  const auto check = look_at(scene, streams);
  streams.write("", options.json ? check_json(*scene, check->findings) : check_text(*scene, check->findings));
  return exit_code(*check);
}

SceneCheck3 look_at(const ValidScene3& scene, const Streams& streams) {
  return scene_check(Simulation3(scene), streams.stages());
}

ExitCode exit_code(const SceneCheck3& check) { return has_error(check.findings) ? ExitCode::kUnmet : ExitCode::kDone; }

// Where that is the file of the scene itself, only if something was repaired; told, as of a RepairedFile.
void write_repaired(const std::string& out, MeshFormat3 format, const Scene3& scene, bool is_repaired,
                    const std::string& input, const Streams& streams) {
  std::error_code missing;
  const bool is_input = std::filesystem::equivalent(out, input, missing) && !missing;
  if (is_repaired || !is_input) write_mesh(out, format, scene, streams);
  if (is_input)
    streams.note(out +
                 (is_repaired ? " is overwritten by the repaired scene" : " is left as it is: nothing is repaired"));
}

// Tells what is found in a scene in space, on standard output. `fix`: where a repaired scene is written, empty:
// nowhere; then what was done is told, and what is found in that. Where it is the `file` of the scene and nothing was
// done, nothing is written; that, or that it was overwritten, is told. `distance`: how far points may be moved, 0: not
// at all.
ExitCode check_in_space(const ValidScene3& scene, const std::string& file, const std::string& fix,
                        const Rational& distance, bool as_json, const Streams& streams) {
  if (fix.empty()) {
    const SceneCheck3 check = look_at(scene, streams);
    streams.write("", as_json ? check_json(*scene, check.findings) : check_text(*scene, check.findings));
    return exit_code(check);
  }
  const auto mesh = mesh_format_3(fix);
  std::optional<RepairedFile> out;
  if (!mesh) out.emplace(fix, file);
  const SceneCheck3 before = look_at(scene, streams);
  std::string text;
  ValidScene3 repaired;
  SceneCheck3 after;
  const Repair3 repair = repair_scene(*scene, distance, before, [&](const Scene3& some) {
    text = with_file_context(scene->file, [&] { return write_scene_3(some); });
    Scene3 written = parse_scene_3(text, fix);
    written.sources = scene->sources;
    if (mesh)
      for (Surface& surface : written.surfaces) surface.line = 0;  // of a scene file that nobody gets
    repaired = std::move(written);
    return after = look_at(repaired, streams);
  });

  std::optional<std::vector<FactorChange>> changes;
  if (before.factors && after.factors)
    changes = factor_changes(*before.factors, *after.factors,
                             [&](const Element& element) { return former_name(repair, element); });
  const RepairReport report{&repair.steps, changes ? &*changes : nullptr};
  if (out) out->write(text, is_anything_done(repair.steps));
  if (mesh)
    with_file_context(file,
                      [&] { write_repaired(fix, *mesh, *repaired, is_anything_done(repair.steps), file, streams); });
  const bool is_left = out && out->is_left();
  const Scene3& told = is_left ? *scene : *repaired;  // of the file that is there, its lines
  const SceneCheck3& found = is_left ? before : after;
  streams.write("", as_json ? check_json(told, found.findings, &report)
                            : repair_text(*scene, report) + check_text(told, found.findings));
  if (out) out->commit(streams);
  return exit_code(found);
}

ExitCode check(const CheckCommandOptions& options, Streams& streams) {
  const Rational distance = distance_of(options);
  const ValidScene scene = read_scene_noting(options.scene, options.polygons, streams);
  if (const auto* in_space = std::get_if<ValidScene3>(&scene))
    return check_in_space(*in_space, options.scene, options.fix, distance, options.json, streams);
  return check_in_plane(options, distance, std::get<ValidScene2>(scene), streams);
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

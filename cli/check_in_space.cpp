#include "cli/check_in_space.h"

#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "cli/mesh_output.h"
#include "cli/repaired_file.h"
#include "io/results/space/check_report.h"
#include "io/scene/scene_json.h"
#include "io/scene/space/mesh_reader.h"
#include "kernel/support/with_file_context.h"
#include "solver/space/check/scene_repair.h"
#include "solver/space/simulation/queries.h"
#include "solver/space/simulation/simulation.h"

namespace hottel {
namespace {

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

}  // namespace

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

}  // namespace hottel

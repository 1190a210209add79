#include "cli/check_in_space.h"

#include <optional>
#include <string>
#include <vector>

#include "cli/repaired_file.h"
#include "io/results/space/check_report.h"
#include "io/scene/scene_json.h"
#include "kernel/support/naming_file.h"
#include "solver/space/check/scene_repair.h"
#include "solver/space/simulation/simulation.h"

namespace hottel {
namespace {

SceneCheck3 look_at(const Scene3& scene, const Streams& streams) {
  const Simulation3 simulation(scene);
  return check_scene(scene, {.prepared = [&] { return simulation.prepared(streams.stages()); },
                             .factors = [&]() -> std::shared_ptr<const ExchangeMatrix> {
                               const auto computed = simulation.factors(streams.stages());
                               return {computed, &computed->matrix};
                             },
                             .lights = [&] { return *simulation.light_shares(streams.stages()); }});
}

ExitCode exit_code(const SceneCheck3& check) { return has_error(check.findings) ? ExitCode::kUnmet : ExitCode::kDone; }

}  // namespace

ExitCode check_in_space(const Scene3& scene, const std::string& file, const std::string& fix, const Rational& distance,
                        bool as_json, const Streams& streams) {
  if (fix.empty()) {
    const SceneCheck3 check = look_at(scene, streams);
    streams.write("", as_json ? check_json(scene, check.findings) : check_text(scene, check.findings));
    return exit_code(check);
  }
  RepairedFile out(fix, file);
  const SceneCheck3 before = look_at(scene, streams);
  std::string text;
  Scene3 repaired;
  SceneCheck3 after;
  const Repair3 repair = repair_scene(scene, distance, before, [&](const Scene3& some) {
    text = naming_file(scene.file, [&] { return write_scene_3(some); });
    repaired = parse_scene_3(text, fix);
    return after = look_at(repaired, streams);
  });

  std::optional<std::vector<FactorChange>> changes;
  if (before.factors && after.factors)
    changes = factor_changes(*before.factors, *after.factors,
                             [&](const Element& element) { return former_name(repair, element); });
  const RepairReport report{&repair.steps, changes ? &*changes : nullptr};
  out.write(text, is_anything_done(repair.steps));
  streams.write("", as_json ? check_json(repaired, after.findings, &report)
                            : repair_text(scene, report) + check_text(repaired, after.findings));
  out.commit(streams);
  return exit_code(after);
}

}  // namespace hottel

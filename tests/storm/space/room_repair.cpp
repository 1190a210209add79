#include "tests/storm/space/room_repair.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <memory>

#include "geometry/space/exchange/exchange.h"
#include "io/scene/scene_json.h"
#include "solver/check/chosen_repair.h"
#include "solver/space/check/scene_repair.h"
#include "tests/storm/space/room_laws.h"

namespace hottel::storm {

namespace {

// How far points may go, from 1e-2 to 1e-12.
Rational distance_of(std::uint64_t chance) {
  Rational distance(1, 100);
  for (std::uint64_t k = chance / 4 % 11; k > 0; --k) distance /= 10;
  return distance;
}

SceneCheck3 check_of(const Scene3& scene) {
  const auto prepared = std::make_shared<const PreparedScene3>(prepare(scene));
  return check_scene(scene,
                     {.prepared = [&] { return prepared; },
                      .factors = [&] { return std::make_shared<const ExchangeMatrix>(exact_exchange(*prepared)); }});
}

std::string counts_text(const Findings3& findings) {
  std::map<std::string, int> counts;
  for (const Finding3& finding : findings) ++counts[finding.kind];
  std::string text;
  for (const auto& [kind, count] : counts) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, kind);
  return text;
}

}  // namespace

std::string room_repair_is_broken(const RoomSubject3& subject) {
  const Rational distance = distance_of(subject.chance());
  const Scene3& scene = subject.scene();
  const SceneCheck3 before = check_of(scene);
  std::string text;
  Scene3 once;
  SceneCheck3 after;
  const auto look = [&](const Scene3& some) {
    text = write_scene_3(some);
    once = parse_scene_3(text, "storm");
    return after = check_of(once);
  };
  repair_scene(scene, distance, before, look);
  std::string wrong;
  const auto told = [&] { return fmt::format("within {}: ", to_string(distance)); };
  if (is_worse(after, before))
    wrong += told() + fmt::format("{}; before: {}\n", counts_text(after.findings), counts_text(before.findings));
  const std::string first = text;
  const SceneCheck3 then = after;
  const Repair3 again = repair_scene(Scene3(once), distance, then, look);
  for (const RepairStep& step : again.steps)
    if (step.kind != "not-repaired") wrong += told() + fmt::format("again {}: {}\n", step.kind, step.message);
  if (text != first) wrong += told() + "another scene the second time\n";
  return wrong;
}

}  // namespace hottel::storm

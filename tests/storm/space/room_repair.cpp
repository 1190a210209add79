#include "tests/storm/space/room_repair.h"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <string>

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

// The same of the room itself, whose factors are known: loose() is within the default tolerance.
SceneCheck3 check_of(const RoomSubject3& subject) {
  return check_scene(subject.scene(), {.prepared = [&] { return subject.prepared(); },
                                       .factors = [&] { return subject.loose_shared(); }});
}

// Scenes written, read back and checked; what is written alike is checked once.
class WrittenChecks {
 public:
  SceneCheck3 operator()(const Scene3& some) {
    text_ = write_scene_3(some);
    scene_ = parse_scene_3(text_, "storm");
    auto known = checks_.find(text_);
    if (known == checks_.end()) known = checks_.emplace(text_, check_of(scene_)).first;
    return known->second;
  }
  // The last one, written and read back, and its check.
  const std::string& text() const { return text_; }
  const Scene3& scene() const { return scene_; }
  const SceneCheck3& check() const { return checks_.at(text_); }

 private:
  std::string text_;
  Scene3 scene_;
  std::map<std::string, SceneCheck3> checks_;  // by text
};

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
  const SceneCheck3 before = check_of(subject);
  WrittenChecks checks;
  repair_scene(scene, distance, before, std::ref(checks));
  const std::string first = checks.text();
  const Scene3 once = checks.scene();
  const SceneCheck3 after = checks.check();
  std::string wrong;
  const auto told = [&] { return fmt::format("within {}: ", to_string(distance)); };
  if (is_worse(after, before))
    wrong += told() + fmt::format("{}; before: {}\n", counts_text(after.findings), counts_text(before.findings));
  const Repair3 again = repair_scene(once, distance, after, std::ref(checks));
  for (const RepairStep& step : again.steps)
    if (step.kind != "not-repaired") wrong += told() + fmt::format("again {}: {}\n", step.kind, step.message);
  if (checks.text() != first) wrong += told() + "another scene the second time\n";
  return wrong;
}

}  // namespace hottel::storm

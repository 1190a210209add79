// Repairs that do no harm: what would is left as it was. Internal to the checks of both dimensions.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "geometry/name.h"
#include "geometry/repair_step.h"
#include "geometry/severity.h"

namespace hottel {

// How much was found that a repair must not add to: warnings and errors; and besides, notes of needles and crossings.
// What other notes tell (t-junction, isolated-cell, covered, ...), and that a face spans two rooms, is how things are
// that touch: a door that is closed parts its rooms.
struct FindingCounts {
  long all = 0, warnings = 0;

  template <class Finding>
  void add(const Finding& finding, long times = 1) {
    if (finding.kind == "spans-rooms") return;
    const bool is_note = finding.severity == Severity::kNote;
    if (!is_note) warnings += times;
    if (!is_note || finding.kind == "needle" || finding.kind == "crossing") all += times;
  }
  bool is_more_than(const FindingCounts& other) const { return all > other.all || warnings > other.warnings; }
};

template <class Findings>
FindingCounts counts_of(const Findings& findings) {
  FindingCounts counts;
  for (const auto& finding : findings) counts.add(finding);
  return counts;
}

// The one way to a repair that does no harm, whatever the dimension. `close(scene, held)` returns a Repair of a scene
// in which surfaces that are held keep their places; Repair::moved has the surfaces that moved together,
// Repair::origins where each came from. `find` returns what is found in a scene.
template <class Scene, class Close, class Find>
class HarmlessRepair {
 public:
  using Surfaces = std::vector<std::uint32_t>;

  // REQUIRES that all outlive this.
  HarmlessRepair(const Scene& scene, const Close& close, const Find& find)
      : scene_(scene), close_(close), find_(find) {}

  // Returns a repair after which no more is found than before, and which leaves its own result as it is. What moves
  // together is left as it was where moved it would move again, or more would be found (not-repaired).
  auto repair() {
    std::vector<char> held(scene_.surfaces.size(), 0);
    std::vector<RepairStep> refused;
    for (;;) {
      auto repair = attempt(held);
      const bool is_done = repair.moved.empty();
      const auto again = is_done ? repair : HarmlessRepair(repair.scene, close_, find_).attempt(none(repair.scene));
      if (is_done || !is_anything_done(again.steps)) {
        repair.steps.insert(repair.steps.end(), refused.begin(), refused.end());
        return repair;
      }
      bool is_more = false;
      for (const Surfaces& together : again.moved)
        for (const std::uint32_t s : together) {
          is_more = is_more || held[repair.origins[s]] == 0;
          held[repair.origins[s]] = 1;
        }
      for (const Surfaces& together : repair.moved) {
        if (!is_more)
          for (const std::uint32_t s : together) held[s] = 1;
        if (std::any_of(together.begin(), together.end(), [&](std::uint32_t s) { return held[s] != 0; }))
          refused.push_back(refusal(together, kWithinReach));
      }
    }
  }

 private:
  static constexpr const char* kWithinReach = "they would come within reach of others";

  static std::vector<char> none(const Scene& scene) { return std::vector<char>(scene.surfaces.size(), 0); }

  // A repair in which surfaces that are held stay, and which passes the tests of repair() but for what it does to its
  // own result as a whole.
  auto attempt(std::vector<char> held) {
    std::vector<RepairStep> refused;
    for (;;) {
      auto repair = close_(scene_, held);
      std::set<std::size_t> harmful;
      const char* reason = kWithinReach;
      if (!repair.moved.empty()) {
        harmful = unsteady(repair, held);
        if (harmful.empty()) {
          harmful = worse(repair);
          reason = "more would be found than is now";
        }
      }
      if (harmful.empty()) {
        repair.steps.insert(repair.steps.end(), refused.begin(), refused.end());
        return repair;
      }
      for (const std::size_t k : harmful) {
        for (const std::uint32_t s : repair.moved[k]) held[s] = 1;
        refused.push_back(refusal(repair.moved[k], reason));
      }
    }
  }

  RepairStep refusal(const Surfaces& surfaces, const char* reason) const {
    return {"not-repaired", scene_.surfaces[surfaces.front()].name,
            fmt::format("{} stay{} as {}: moved, {}", names(surfaces), surfaces.size() == 1 ? "s" : "",
                        surfaces.size() == 1 ? "it was" : "they were", reason)};
  }

  std::string names(const Surfaces& surfaces) const {
    constexpr std::size_t kMost = 3;
    std::string text;
    for (std::size_t k = 0; k < std::min(kMost, surfaces.size()); ++k)
      text += (k == 0 ? "" : ", ") + quoted_name(scene_.surfaces[surfaces[k]].name);
    if (surfaces.size() > kMost) text += fmt::format(" and {} more", surfaces.size() - kMost);
    return text;
  }

  template <class Repair>
  static std::set<std::size_t> all_of(const Repair& repair) {
    std::set<std::size_t> all;
    for (std::size_t k = 0; k < repair.moved.size(); ++k) all.insert(k);
    return all;
  }

  // Which of those that moved together a surface of the scene is of; as many as there are: of none.
  template <class Repair>
  std::vector<std::size_t> moves_of(const Repair& repair) const {
    std::vector<std::size_t> moves(scene_.surfaces.size(), repair.moved.size());
    for (std::size_t k = 0; k < repair.moved.size(); ++k)
      for (const std::uint32_t s : repair.moved[k]) moves[s] = k;
    return moves;
  }

  // What would move once more.
  template <class Repair>
  std::set<std::size_t> unsteady(const Repair& repair, const std::vector<char>& held) const {
    const Surfaces& origin = repair.origins;
    std::vector<char> still_held;
    for (const std::uint32_t s : origin) still_held.push_back(held[s]);
    const Repair again = close_(repair.scene, still_held);
    if (!is_anything_done(again.steps)) return {};
    const std::vector<std::size_t> moves = moves_of(repair);
    std::set<std::size_t> found;
    for (const Surfaces& together : again.moved)
      for (const std::uint32_t s : together)
        if (const std::size_t k = moves[origin[s]]; k < repair.moved.size()) found.insert(k);
    return found.empty() ? all_of(repair) : found;
  }

  // What more is found of than before; nothing where no more is found in all.
  template <class Repair>
  std::set<std::size_t> worse(const Repair& repair) {
    if (!is_looked_at_) before_ = find_(scene_);
    is_looked_at_ = true;
    const auto after = find_(repair.scene);
    if (!counts_of(after).is_more_than(counts_of(before_))) return {};
    const std::vector<std::size_t> moves = moves_of(repair);
    std::vector<FindingCounts> counts(repair.moved.size() + 1);
    const auto add = [&](const auto& findings, const auto& origin_of, long times) {
      for (const auto& finding : findings) {
        std::set<std::size_t> touched;
        for (const std::uint32_t s : finding.surfaces) touched.insert(moves[origin_of(s)]);
        for (const std::size_t k : touched) counts[k].add(finding, times);
      }
    };
    const Surfaces& origin = repair.origins;
    add(
        before_, [](std::uint32_t s) { return s; }, -1);
    add(
        after, [&](std::uint32_t s) { return origin[s]; }, 1);
    std::set<std::size_t> found;
    for (std::size_t k = 0; k < repair.moved.size(); ++k)
      if (counts[k].is_more_than({})) found.insert(k);
    return found.empty() ? all_of(repair) : found;
  }

  const Scene& scene_;
  const Close& close_;
  const Find& find_;
  bool is_looked_at_ = false;
  decltype(std::declval<const Find&>()(std::declval<const Scene&>())) before_{};
};

}  // namespace hottel

#include "solver/plane/check/scene_repair.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "solver/check/chosen_repair.h"
#include "solver/check/rooms_left.h"

namespace hottel {
namespace {

// Drops of the steps from this one on those that were told before.
void drop_told_before(std::vector<RepairStep>& steps, std::size_t first) {
  const auto is_told = [&](const RepairStep& step) {
    return std::any_of(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(first), [&](const RepairStep& told) {
      return told.kind == step.kind && told.surface == step.surface && told.message == step.message;
    });
  };
  std::vector<RepairStep> kept(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(first));
  for (std::size_t k = first; k < steps.size(); ++k)
    if (!is_told(steps[k])) kept.push_back(steps[k]);
  steps = std::move(kept);
}

}  // namespace

Repair2 repair_scene(const Scene2& scene, const Rational& distance, const SceneCheck2& before,
                     const RepairLooks2& looks) {
  const auto stated = [&](Repair2 repair) {
    reverse_inside_out(repair);
    const bool is_as_before = repair.steps.empty() && repair.scene.edges == scene.edges;
    state_solids(repair, is_as_before ? before.black_backs : looks.check(repair.scene)->black_backs);
    // What is solid now may bring others to light.
    const auto solids = [&] { return std::ranges::count(repair.steps, "solid", &RepairStep::kind); };
    for (std::ptrdiff_t told = 0; solids() > told;) {
      told = solids();
      const std::size_t steps = repair.steps.size();
      state_solids(repair, looks.check(repair.scene)->black_backs);
      drop_told_before(repair.steps, steps);
    }
    restore_polylines(repair);
    return repair;
  };
  std::vector<std::function<Repair2()>> ways{[&] { return stated(unrepaired(scene)); },
                                             [&] { return unrepaired(scene); }};
  if (distance > 0) ways.insert(ways.begin(), [&] { return stated(close_gaps(scene, distance)); });
  Repair2 repair = chosen_repair(before, ways, [&](const Repair2& some) { return *looks.check_written(some.scene); });
  tell_rooms_left(scene, before.findings, repair.steps);
  return repair;
}

}  // namespace hottel

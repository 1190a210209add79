#include "solver/plane/check/scene_repair.h"

#include <vector>

#include "solver/check/chosen_repair.h"

namespace hottel {

Repair2 repair_scene(const Scene2& scene, const Rational& distance, const SceneCheck2& before,
                     const RepairLooks2& looks) {
  const auto stated = [&](Repair2 repair) {
    reverse_inside_out(repair);
    const bool is_as_before = repair.steps.empty() && repair.scene.edges == scene.edges;
    state_solids(repair, is_as_before ? before.black_backs : looks.check(repair.scene)->black_backs);
    restore_polylines(repair);
    return repair;
  };
  std::vector<std::function<Repair2()>> ways{[&] { return stated(unrepaired(scene)); },
                                             [&] { return unrepaired(scene); }};
  if (distance > 0) ways.insert(ways.begin(), [&] { return stated(close_gaps(scene, distance)); });
  return chosen_repair(before, ways, [&](const Repair2& repair) { return *looks.check_written(repair.scene); });
}

}  // namespace hottel

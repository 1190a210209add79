#include "solver/space/check/scene_repair.h"

#include <vector>

#include "solver/check/chosen_repair.h"
#include "solver/check/rooms_left.h"

namespace hottel {

Repair3 repair_scene(const Scene3& scene, const Rational& distance, const SceneCheck3& before,
                     const std::function<SceneCheck3(const Scene3&)>& check_written) {
  const auto tidied = [&] {
    Repair3 repair = unrepaired(scene);
    tidy(repair);
    return repair;
  };
  std::vector<std::function<Repair3()>> ways{tidied, [&] { return unrepaired(scene); }};
  if (distance > 0) ways.insert(ways.begin(), [&] { return close_gaps(scene, distance); });
  Repair3 repair = chosen_repair(before, ways, [&](const Repair3& some) { return check_written(some.scene); });
  tell_rooms_left(scene, before.findings, repair.steps);
  return repair;
}

}  // namespace hottel

// What a repair leaves as it is, though a room may have been meant.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/name.h"
#include "geometry/repair_step.h"
#include "geometry/scene_table.h"

namespace hottel {

// Adds a step (not-repaired) for each solid with something in it (filled-room), unless the scene says that it is one.
// `findings`: of the scene before the repair.
template <class Findings>
void tell_rooms_left(const SceneTable& scene, const Findings& findings, std::vector<RepairStep>& steps) {
  for (const auto& finding : findings) {
    if (finding.kind != "filled-room") continue;
    const Surface& surface = scene.surfaces[finding.surfaces.front()];
    const Group& group = scene.groups[surface.group];
    if (group.behind == Behind::kByOutline)
      steps.push_back({"not-repaired", surface.name,
                       quoted_name(group.name) + " is left as it is, for it may be meant as a solid: where it is a "
                                                 "room, list its points the other way round"});
  }
}

}  // namespace hottel

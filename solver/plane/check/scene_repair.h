// A scene in the plane repaired, without harm.
#pragma once

#include <functional>
#include <memory>

#include "geometry/plane/check/repair.h"
#include "solver/plane/check/scene_check.h"

namespace hottel {

// Where a repair takes what is found in a scene.
struct RepairLooks2 {
  std::function<std::shared_ptr<const SceneCheck2>(const Scene2&)> check;
  std::function<std::shared_ptr<const SceneCheck2>(const Scene2&)> check_written;  // as its file is read back
};

// Returns the scene repaired: gaps closed within a distance (close_gaps), where it is not 0; then what is inside out
// reversed (reverse_inside_out), what is behind stated (state_solids), polylines restored (restore_polylines).
//
//   (1) the scene that is returned is no worse than before (is_worse). Where it would be it is repaired without closing
//       gaps, and where that is worse too it stays as it is: what was not done is told (not-repaired),
//       and so are solids that may be meant as rooms (tell_rooms_left)
//   (2) to repair it once more changes nothing but the order of surfaces
//   (3) check_written is asked of it last
// `before`: of the scene.
Repair2 repair_scene(const Scene2& scene, const Rational& distance, const SceneCheck2& before,
                     const RepairLooks2& looks);

}  // namespace hottel

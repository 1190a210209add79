// A scene in space repaired, without harm.
#pragma once

#include <functional>

#include "geometry/space/check/repair.h"
#include "solver/space/check/scene_check.h"

namespace hottel {

// Returns the scene repaired: tidied (tidy), and gaps closed within a distance (close_gaps), where it is not 0.
//
//   (1) the scene that is returned is no worse than before (is_worse). Where it would be it is repaired without closing
//       gaps, and where that is worse too it stays as it is: what was not done is told (not-repaired),
//       and so are solids that may be meant as rooms (tell_rooms_left)
//   (2) to repair it once more changes nothing: each way begins with what the next one does, so a way that made the
//       scene worse makes what the next one returns worse too
//   (3) check_written is asked of it last
// `before`: of the scene; check_written: of a scene as its file is read back.
Repair3 repair_scene(const Scene3& scene, const Rational& distance, const SceneCheck3& before,
                     const std::function<SceneCheck3(const Scene3&)>& check_written);

}  // namespace hottel

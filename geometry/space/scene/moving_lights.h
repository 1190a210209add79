// The lights of a scene in space after some time.
#pragma once

#include "geometry/space/scene/scene.h"

namespace hottel {

// Returns where a light is, and where it shines, after some seconds; it does not move from there.
//
//   (1) its axis is Rz Ry Rx direction, each angle rotation * time within a turn, exactly; rounded to doubles, and
//       exact from there. After whole turns it is the direction again
//   (2) on a path its position is rounded to doubles (place_on_path), and exact from there
LightPlace3 place_after(const LightPlace3& place, const Rational& time);

// True iff some light of the scene turns or follows a path. A point light that turns does not move.
bool has_moving_lights(const Scene3& scene);

// The scene after some seconds, its lights at rest. REQUIRES time >= 0.
Scene3 scene_after(Scene3 scene, const Rational& time);

}  // namespace hottel

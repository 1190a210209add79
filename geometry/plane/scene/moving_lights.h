// The lights of a scene in the plane after some time.
#pragma once

#include "geometry/plane/scene/scene.h"

namespace hottel {

// Returns where a light is, and where it shines, after some seconds; it does not move from there.
//
//   (1) its axis is turned by rotation * time, exactly, within a turn; after whole turns it is the same again
//   (2) on a path its position is rounded to doubles (place_on_path), and exact from there
LightPlace2 place_after(const LightPlace2& place, const Rational& time);

// The direction of a light as it stands: that of its place, turned as that says. By quarters of a turn it is exact;
// else it is rounded to doubles, of a vector whose largest component is 1, and exact from there.
Point2 turned_direction(const LightPlace2& place);

// True iff some light of the scene turns or follows a path. A point light that turns does not move.
bool has_moving_lights(const Scene2& scene);

// The scene after some seconds, its lights at rest. REQUIRES time >= 0.
Scene2 scene_after(Scene2 scene, const Rational& time);

}  // namespace hottel

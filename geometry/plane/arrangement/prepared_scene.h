// A scene made ready to be asked: overlaid, owned and triangulated.
#pragma once

#include "geometry/plane/arrangement/arrangement.h"
#include "geometry/plane/scene/scene.h"

namespace hottel {

// A scene overlaid and triangulated: what every method receives, and what visibility is asked of.
// COST: O((n + k) log n) for n edges with k contacts.
struct PreparedScene2 {
  Scene2 scene;
  Division2 division;
  Arrangement2 arrangement;
  double seconds = 0;  // what the preparation took
};

// Prepares a scene with the number of elements each surface asks for (needed for Granularity::kElement only; whole
// surfaces are cheaper otherwise). Throws InputError when claims on an overlap conflict.
enum class Divided2 : bool { kNo, kYes };
PreparedScene2 prepare(Scene2 scene, Divided2 divided = Divided2::kNo);

}  // namespace hottel

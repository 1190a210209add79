// A scene made ready to be asked: overlaid, owned and triangulated.
#pragma once

#include "geometry/plane/arrangement/arrangement.h"
#include "geometry/plane/scene/scene.h"

namespace hottel {

// A scene overlaid and triangulated: what every method receives, and what visibility is asked of.
//
//   (1) division has one number a surface: the equal parts that the arrangement was made with, 1 where it
//       is not divided
//   (2) while nobody changes it, any number of threads may use it at once
//
// COST: O((n + k) log n) for n edges with k contacts.
struct PreparedScene2 {
  Scene2 scene;
  Division2 division;
  Arrangement2 arrangement;
  double seconds = 0;  // what the preparation took
};

// Whether the parts of surfaces are told apart. kYes is needed for Granularity::kElement only: whole
// surfaces are cheaper.
enum class Divided2 : bool { kNo, kYes };
// Prepares a scene, with as many parts of each surface as it asks for (Surface::elements), or with one. It rounds to
// nearest, whatever the caller has set.
// Throws InputError when claims on an overlap conflict, or for a "behind" that cannot be obeyed.
// REQUIRES: a valid scene (validate).
PreparedScene2 prepare(Scene2 scene, Divided2 divided = Divided2::kNo);

}  // namespace hottel

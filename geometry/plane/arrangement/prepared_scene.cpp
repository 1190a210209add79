#include "geometry/plane/arrangement/prepared_scene.h"

#include "kernel/support/parallel.h"
#include "kernel/support/stopwatch.h"

namespace hottel {

PreparedScene2 prepare(Scene2 scene, Divided2 divided) {
  const DefaultFloatingPoint arithmetic;
  Stopwatch watch;
  Division2 division;
  for (const Surface& surface : scene.surfaces) division.push_back(divided == Divided2::kYes ? surface.elements : 1);
  auto arrangement = std::make_shared<const Arrangement2>(scene, division);
  return {std::move(scene), std::move(division), std::move(arrangement), watch.lap()};
}

}  // namespace hottel

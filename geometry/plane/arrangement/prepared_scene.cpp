#include "geometry/plane/arrangement/prepared_scene.h"

#include "kernel/support/parallel.h"
#include "kernel/support/stopwatch.h"

namespace hottel {

PreparedScene2 prepare(Scene2 scene, Divided2 divided) {
  const DefaultFloatingPoint arithmetic;
  Stopwatch watch;
  Division2 division;
  for (const Surface& surface : scene.surfaces) division.push_back(divided == Divided2::kYes ? surface.elements : 1);
  Arrangement2 arrangement(scene, division);
  PreparedScene2 prepared{std::move(scene), std::move(division), std::move(arrangement), 0};
  prepared.seconds = watch.lap();
  return prepared;
}

}  // namespace hottel

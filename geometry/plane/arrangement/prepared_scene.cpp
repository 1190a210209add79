#include "geometry/plane/arrangement/prepared_scene.h"

#include "kernel/support/parallel.h"
#include "kernel/support/stopwatch.h"

namespace hottel {

PreparedScene2 prepare(Scene2 scene, Divided2 divided) {
  const DefaultFloatingPoint arithmetic;
  Stopwatch watch;
  const Division2 nowhere(scene.surfaces.size());
  auto arrangement = std::make_shared<const Arrangement2>(scene, nowhere);
  PreparedScene2 undivided(std::move(scene), nowhere, std::move(arrangement), watch.lap());
  if (divided == Divided2::kNo) return undivided;
  return prepare_divided(undivided, undivided.scene);
}

PreparedScene2 prepare_divided(const PreparedScene2& undivided, Scene2 scene) {
  const DefaultFloatingPoint arithmetic;
  Stopwatch watch;
  Division2 division = division_of(scene);
  auto arrangement = is_cut(division)
                         ? std::make_shared<const Arrangement2>(undivided.arrangement.cut_into(scene, division))
                         : undivided.shared;
  return {std::move(scene), std::move(division), std::move(arrangement), undivided.seconds + watch.lap()};
}

}  // namespace hottel

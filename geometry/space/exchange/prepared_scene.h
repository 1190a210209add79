// A scene in space made ready to be asked: its pieces as blockers, and what measures pairs among them.
#pragma once

#include <memory>

#include "geometry/space/arrangement/arrangement.h"
#include "geometry/space/arrangement/blockers.h"
#include "geometry/space/exchange/pair_measure.h"
#include "geometry/space/scene/scene.h"

namespace hottel {

// What every computation of view factors in space receives.
//
//   (1) blockers are the pieces of the arrangement: a "surface" of blockers and patches is a piece. How polygons are
//       divided into elements plays no part
//   (2) while nobody changes it, any number of threads may use it at once
//   (3) copies share the arrangement and the blockers, which live as long as one of them
struct PreparedScene3 {
  struct Ready {
    explicit Ready(const Scene3& scene) : arrangement(scene), blockers(arrangement.polygons()), measurer(blockers) {}
    Arrangement3 arrangement;
    Blockers3 blockers;
    PairMeasurer3 measurer;
  };

  Scene3 scene;
  std::shared_ptr<const Ready> ready;
  double seconds = 0;  // what the preparation took

  const Arrangement3& arrangement() const { return ready->arrangement; }
  const Blockers3& blockers() const { return ready->blockers; }
  const PairMeasurer3& measurer() const { return ready->measurer; }
};

// Prepares a scene. Throws InputError as Arrangement3 does. REQUIRES: a valid scene (validate). COST: that of
// Arrangement3 and Blockers3.
PreparedScene3 prepare(Scene3 scene);

}  // namespace hottel

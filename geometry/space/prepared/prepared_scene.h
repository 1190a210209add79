// A preprocessed scene in space: its pieces as occluders, and what measures pairs among them.
#pragma once

#include <memory>
#include <utility>

#include "geometry/element_tables.h"
#include "geometry/space/arrangement/arrangement.h"
#include "geometry/space/arrangement/occluders.h"
#include "geometry/space/pairs/pair_integrator.h"
#include "geometry/space/scene/scene.h"

namespace hottel {

class ElementTable3;

// What every computation of view factors in space receives.
//
//   (1) occluders are the pieces of the arrangement: a "surface" of occluders and patches is a piece. How polygons are
//       divided into elements plays no part
//   (2) while nobody changes it, any number of threads may use it at once
//   (3) copies share the arrangement, the occluders and the tables of elements, which live as long as one of them
//   (4) a table of elements is made when it is first asked for, once
struct PreparedScene3 {
  struct Ready {
    explicit Ready(const Scene3& scene) : arrangement(scene), occluders(arrangement.polygons()), measurer(occluders) {}
    Arrangement3 arrangement;
    Occluders3 occluders;
    PairIntegrator3 measurer;
  };

  Scene3 scene;
  std::shared_ptr<const Ready> ready;
  double seconds;  // what the preparation took

  // REQUIRES what is made ready to be of this scene, or of one that differs from it in values of materials and of the
  // sky, in how surfaces are divided, in its lights and its grid only.
  PreparedScene3(Scene3 its_scene, std::shared_ptr<const Ready> of_it, double took);
  // The same, ready, under such another scene.
  PreparedScene3 under(Scene3 other) const { return {std::move(other), ready, seconds}; }

  const Arrangement3& arrangement() const { return ready->arrangement; }
  const Occluders3& occluders() const { return ready->occluders; }
  const PairIntegrator3& measurer() const { return ready->measurer; }
  // Which patches each element is made of. COST: that of the table, for the first who asks.
  std::shared_ptr<const ElementTable3> elements(Granularity granularity) const;

 private:
  std::shared_ptr<ElementTables<ElementTable3>> tables_;
};

// Prepares a scene. Throws InputError as Arrangement3 does. REQUIRES: a valid scene (validate). COST: that of
// Arrangement3 and Occluders3.
PreparedScene3 prepare(Scene3 scene);

}  // namespace hottel

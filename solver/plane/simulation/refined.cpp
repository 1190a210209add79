#include "solver/plane/simulation/refined.h"

#include "geometry/plane/prepared/prepared_scene.h"
#include "solver/plane/light/refinement.h"

namespace hottel {

Simulation2 refined(const Simulation2& simulation, const RefinementLevels& levels, const StageProgress& progress) {
  if (!levels.is_any()) return simulation;
  return simulation.with_trees(refined_trees(*simulation.prepared(progress), levels));
}

}  // namespace hottel

#include "solver/space/simulation/refined.h"

#include "geometry/space/prepared/prepared_scene.h"
#include "kernel/support/failure.h"
#include "solver/space/light/refinement.h"

namespace hottel {

Simulation3 refined(const Simulation3& simulation, const RefinementLevels& levels, const StageProgress& progress) {
  if (!levels.is_any()) return simulation;
  HOTTEL_REQUIRE(simulation.request().factors.granularity == Granularity::kElement);
  return simulation.with_trees(refined_trees(*simulation.prepared(progress), levels));
}

}  // namespace hottel

#include "solver/plan_speed.h"

#include "kernel/support/failure.h"

namespace hottel {

Plan plan_at_speed(const Plan& plan, double slowness) {
  HOTTEL_REQUIRE(slowness > 0);
  std::vector<PlannedEffect> effects = plan.effects();
  for (PlannedEffect& effect : effects) effect.seconds_estimate *= slowness;
  return Plan(std::move(effects));
}

}  // namespace hottel

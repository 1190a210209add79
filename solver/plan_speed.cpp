#include "solver/plan_speed.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr double kAlone = 0.1;  // of what works on all threads: the part that one of them does

bool is_shared(std::string_view effect) {
  constexpr std::array<std::string_view, 4> kShared{Plan::kExchange, Plan::kOcclusion, Plan::kSky, Plan::kIllumination};
  return std::ranges::find(kShared, effect) != kShared.end();
}

}  // namespace

double shared_seconds(double seconds, const MachineSpeed& speed) {
  return seconds * speed.slowness * (kAlone + (1 - kAlone) / speed.threads);
}

Plan plan_at_speed(const Plan& plan, const MachineSpeed& speed) {
  HOTTEL_REQUIRE(speed.slowness > 0 && speed.threads >= 1);
  std::vector<PlannedEffect> effects = plan.effects();
  for (PlannedEffect& effect : effects) {
    effect.seconds_estimate = is_shared(effect.effect) ? shared_seconds(effect.seconds_estimate, speed)
                                                       : effect.seconds_estimate * speed.slowness;
  }
  return Plan(std::move(effects));
}

}  // namespace hottel

#include "solver/store_plan.h"

#include <utility>
#include <vector>

namespace hottel {

Plan plan_with_store(const Plan& plan, bool is_in_space, const std::string& method) {
  std::vector<PlannedEffect> effects = plan.effects();
  const bool is_quick = !is_in_space && method == "exact";
  effects.push_back({.effect = kStoreEffect,
                     .used = true,
                     .reason = is_quick
                                   ? "view factors are kept, which may cost more than it saves: in the plane they "
                                     "take about as long to read as to compute"
                                   : "view factors are kept: a later run reads what it has in common with this one",
                     .seconds_estimate = 0});
  return Plan(std::move(effects));
}

}  // namespace hottel

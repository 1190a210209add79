#include "solver/plan_nodes.h"

#include <algorithm>
#include <string>

#include "kernel/support/failure.h"
#include "solver/plan_speed.h"
#include "solver/radiosity/radiosity_options.h"
#include "solver/radiosity/row_crew.h"

namespace hottel {
namespace {

// Of one row of factors a helper holds columns, factors, sides and visibilities, and the same row made symmetric.
constexpr double kBytesOfAnEntry = 21 + 12, kBytesOfAnUnknown = 250;

double total(const Plan& plan) {
  double sum = 0;
  for (const PlannedEffect& effect : plan.effects()) sum += effect.seconds_estimate;
  return sum;
}

// Null where no radiosities are solved for.
const MemoryStage* radiosities_of(const MemoryEstimate& memory) {
  for (const MemoryStage& stage : memory.stages())
    if (stage.name == "radiosity") return &stage;
  return nullptr;
}

double entries_of(const MemoryEstimate& memory) { return 2 * memory.stages()[1].count; }

bool is_shared(const std::string& effect, const MemoryEstimate& memory) {
  if (effect == Plan::kExchange || effect == Plan::kOcclusion || effect == Plan::kSky) return true;
  const MemoryStage* const solution = radiosities_of(memory);
  return effect == Plan::kInterreflection && solution != nullptr && solution->count > kMostDenseUnknowns &&
         entries_of(memory) >= static_cast<double>(kLeastSharedEntries);
}

}  // namespace

PlannedNodes planned_nodes(const Plan* plan, double preparing, double slowness, const MemoryEstimate& memory,
                           const Nodes& nodes) {
  HOTTEL_REQUIRE(nodes.count >= 1 && nodes.cores >= 1 && memory.stages().size() >= 2);
  PlannedNodes result{.nodes = nodes};
  if (plan != nullptr) {
    const MachineSpeed one_node{slowness, nodes.cores};
    const Plan on_one_node = plan_at_speed(*plan, one_node);
    double shared = 0;
    for (const PlannedEffect& effect : on_one_node.effects())
      if (is_shared(effect.effect, memory)) shared += effect.seconds_estimate;
    shared = std::max(0.0, shared - shared_seconds(preparing, one_node));
    result.seconds_of_one_core = total(plan_at_speed(*plan, {slowness, 1}));
    result.seconds_of_one_node = total(on_one_node);
    result.seconds = *result.seconds_of_one_node - shared + shared_seconds(shared, {1, nodes.count});
  }
  result.first_bytes = memory.peak();
  result.other_bytes = memory.stages()[0].bytes;
  if (const MemoryStage* const solution = radiosities_of(memory))
    result.other_bytes += solution->count * kBytesOfAnUnknown + entries_of(memory) / nodes.count * kBytesOfAnEntry;
  return result;
}

}  // namespace hottel

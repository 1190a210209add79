// A plan on several nodes of a cluster: a model, made of what one process takes.
#pragma once

#include <optional>

#include "solver/memory_estimate.h"
#include "solver/plan.h"

namespace hottel {

// Alike, with one process each.
struct Nodes {
  int count = 1, cores = 1;  // cores: of each
  double memory = 0;         // of each, in bytes
};

// What several nodes would take.
//
//   (1) seconds are those of plan_at_speed() for the cores of one node. What processes share, view factors and
//       radiosities that are iterated, is divided by the number of nodes, but for a tenth; all else is done by the
//       first node alone, or by each for itself. Time on the network is not counted
//   (2) the first node takes the memory of one process; every other one has the elements, and its rows while
//       radiosities are solved for
//   (3) more nodes need no less memory of the first one: the least number is 1, or there is none
struct PlannedNodes {
  Nodes nodes;
  // Nothing where there is no plan.
  std::optional<double> seconds{}, seconds_of_one_node{}, seconds_of_one_core{};
  double first_bytes = 0, other_bytes = 0;

  // Whether so much memory suffices, for any number of nodes.
  bool fits() const { return first_bytes <= nodes.memory; }
};

// plan: on one core of the machine of the constants; null where nothing is known of the time. preparing: seconds of its
// view factors that each process takes for itself. slowness: of a core of the nodes. REQUIRES at least one node and one
// core, an estimate that has factors.
PlannedNodes planned_nodes(const Plan* plan, double preparing, double slowness, const MemoryEstimate& memory,
                           const Nodes& nodes);

}  // namespace hottel

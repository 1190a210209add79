// What the integrand of a part is at the nodes of a rule, within proven bounds, at many nodes at once. Internal to
// geometry/space.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "geometry/space/proven/ball.h"
#include "geometry/space/proven/part_arcs.h"
#include "kernel/legendre_rule.h"

namespace hottel {

// So many nodes are taken at once.
inline constexpr std::size_t kNodeLanes3 = 8;

// Returns the mean of the formula of a part at the nodes of a rule, with their weights. `turns`: of each arc the sign
// that its angle has wherever it is more than a right angle, where that is known; else 0. Nothing where an angle may be
// half a turn either way.
//
//   (1) the same bits on every processor
//
// COST: for eight nodes some 10 ns a vector, 20 ns an arc.
std::optional<Ball3<double>> mean_at_nodes_3(const PartArcs3& part, std::span<const signed char> turns,
                                             const LegendreRule<double>& rule);

}  // namespace hottel

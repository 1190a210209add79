// What the integrand of a part is at the nodes of a rule, within proven bounds, in many digits. Internal to
// geometry/space.
#pragma once

#include <optional>
#include <span>

#include "geometry/space/proven/ball.h"
#include "geometry/space/proven/proven_piece.h"
#include "kernel/legendre_rule.h"
#include "kernel/wide_real.h"

namespace hottel {

// As mean_at_nodes_3() of node_lanes.h, between two t.
std::optional<Ball3<WideReal>> mean_at_nodes_3(const ProvenPiece3<WideReal>& piece,
                                               const ProvenMoment3<WideReal>& moment,
                                               std::span<const signed char> turns, const LegendreRule<WideReal>& rule,
                                               double low, double high);

}  // namespace hottel

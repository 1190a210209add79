// Which segments come near which points: the candidates that exact arithmetic then decides about.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/arrangement/overlay_2.h"
#include "kernel/vertices_2.h"

namespace hottel {

// Returns for each vertex the segments that come within `reach[vertex]` of it, ascending, and maybe more. Reaches are
// in the units of Vertices2::approximate. COST: O((n + k) log n) for k pairs whose boxes meet.
std::vector<std::vector<std::uint32_t>> segments_near_vertices(const Vertices2& vertices,
                                                               const std::vector<Segment2>& segments,
                                                               const std::vector<double>& reach);

}  // namespace hottel

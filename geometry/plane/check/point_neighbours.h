// Which segments come near which points: the candidates that exact arithmetic then decides about.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/plane/arrangement/overlay.h"
#include "geometry/plane/predicates/vertices.h"

namespace hottel {

// Bounds of the distance of a vertex from a segment, in the units of Vertices2::approximate.
//
//   (1) lower <= the real distance <= upper; so lower is 0 or negative where the two touch
//   (2) the segment may be a point
struct DistanceBounds2 {
  double lower = 0, upper = 0;
};
// In doubles: no exact coordinate is looked at.
DistanceBounds2 distance_bounds(const Vertices2& vertices, const Segment2& segment, VertexId v);

// Returns for each vertex the segments near it, ascending. Reaches are in the units of Vertices2::approximate.
//
//   (1) every segment that comes within `reach[vertex]` of the vertex is in its list, those that end there too
//   (2) others may be in it: exact arithmetic is to decide about all of them
//
// REQUIRES: one reach for each vertex.
// COST: O((n + k) log n) for k pairs whose boxes meet. Segments have several boxes along them, the more the larger one
// box would be: of n spokes of a wheel, whose boxes all meet, a tip is near those of few.
std::vector<std::vector<std::uint32_t>> segments_near_vertices(const Vertices2& vertices,
                                                               const std::vector<Segment2>& segments,
                                                               const std::vector<double>& reach);

}  // namespace hottel

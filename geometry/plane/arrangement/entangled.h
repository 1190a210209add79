// Which segments meet others in more than common end points.
#pragma once

#include <vector>

#include "geometry/plane/arrangement/segment.h"
#include "geometry/plane/predicates/vertices.h"

namespace hottel {

// Returns for each segment whether it is entangled with another one: they cross, an end of one lies inside the other,
// or they share a length. REQUIRES segments that are not points, no two with the same two ends.
// COST: O(n log n) where none is, however many meet at one vertex; and each entangled one is tested against those whose
// bounding boxes meet its own.
std::vector<char> find_entangled(const Vertices2& vertices, const std::vector<Segment2>& segments);

// Marks with 1 a set of segments without which none of the others are entangled with each other: a part of
// the entangled ones.
//
// A line sweeps over the plane (Shamos, Hoey 1976). Two neighbours on it that are entangled are both taken away, and
// it goes on with the rest.
//
// REQUIRES: what find_entangled does. COST: O(n log n).
std::vector<char> entangled_neighbours(const Vertices2& vertices, const std::vector<Segment2>& segments);

}  // namespace hottel

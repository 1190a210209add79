// An order of vertices in which neighbours in space are near each other: for cache locality and fast insertion.
#pragma once

#include <vector>

#include "geometry/plane/predicates/vertices.h"

namespace hottel {

// Returns the numbers of vertices or points along a Hilbert curve over their bounding box. Nothing exact
// depends on it.
//
//   (1) each number from 0 on stands in the list once
//   (2) points in one cell of the 2^16 x 2^16 grid, and all of them where the box is a point, are in the order
//       of their numbers
//
// COST: O(n log n), in doubles.
std::vector<VertexId> hilbert_order(const Vertices2& vertices);
std::vector<std::size_t> hilbert_order(const std::vector<Vertices2::Approximate>& points);

}  // namespace hottel

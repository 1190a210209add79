// An order of vertices in which neighbours in space are near each other: for cache locality and fast insertion.
#pragma once

#include <vector>

#include "geometry/plane/predicates/vertices.h"

namespace hottel {

// Returns the vertex numbers along a Hilbert curve over their bounding box. Nothing exact depends on it.
std::vector<VertexId> hilbert_order(const Vertices2& vertices);
std::vector<std::size_t> hilbert_order(const std::vector<Vertices2::Approximate>& points);

}  // namespace hottel

// A segment between two vertices of a scene.
#pragma once

#include "geometry/plane/predicates/vertices.h"

namespace hottel {

// A segment from a to b, by the numbers of its ends; b to a is the same set of points but another Segment2. Both ends
// may be one vertex, where nothing says otherwise.
struct Segment2 {
  VertexId a, b;
};

}  // namespace hottel

// A segment between two vertices of a scene.
#pragma once

#include "geometry/plane/predicates/vertices.h"

namespace hottel {

// From a to b. The two may be one vertex, where nothing says otherwise.
struct Segment2 {
  VertexId a, b;
};

}  // namespace hottel

#include "geometry/plane/visibility/view.h"

namespace hottel {

void look_around(const Vertices2& vertices, const Triangulation2& triangulation, VertexId v, View2& view) {
  look_around<Vertices2>(vertices, triangulation, v, view);
}

}  // namespace hottel

// Vertices by number: 3_v.
#pragma once

#include "geometry/plane/predicates/vertices.h"

namespace hottel {

constexpr VertexId operator""_v(unsigned long long number) { return VertexId(number); }

}  // namespace hottel

// Places of space that a user types.
#pragma once

#include <string_view>

#include "geometry/space/point.h"
#include "viewer/edit/typed_numbers.h"

namespace hottel {

// Reads three exact numbers (typed_numbers): "1, 2/3, 0", "0.1 0.2 0.3".
Typed<Point3> typed_point_3(std::string_view text);

}  // namespace hottel

// Points that a user types.
#pragma once

#include <string_view>

#include "geometry/plane/point.h"
#include "viewer/edit/typed_numbers.h"

namespace hottel {

// Reads two exact numbers (typed_numbers): "1, 2/3", "0.1 0.2".
Typed<Point2> typed_point_2(std::string_view text);

}  // namespace hottel

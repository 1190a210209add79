// Points of the plane.
#pragma once

#include "kernel/rational.h"

namespace hottel {

// A point with exact coordinates: of the scene as it was typed, or, where that is said, in integer form (Vertices2).
struct Point2 {
  Rational x, y;
  friend bool operator==(const Point2&, const Point2&) = default;
};

}  // namespace hottel

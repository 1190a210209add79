// Where a light of a scene in the plane is, where it shines, and how it moves.
#pragma once

#include <optional>
#include <vector>

#include "geometry/plane/point.h"

namespace hottel {

// A way through points at constant speed, once in so many seconds; a closed one leads back to its first point, and is
// walked over and over.
struct LightPath2 {
  std::vector<Point2> points;  // two at least, not all the same
  Rational seconds = 1;        // above 0
  bool closed = false;
  friend bool operator==(const LightPath2&, const LightPath2&) = default;
};

// One light of a scene: what Light leaves open.
struct LightPlace2 {
  Point2 position;         // of no meaning for a sun
  Point2 direction{1, 0};  // of a spot: along the axis of its beam; of a sun: of its rays; of any length, not zero
  Rational turned = 0;     // how far the axis is turned from there, in degrees, counter-clockwise
  Rational rotation = 0;   // of the axis, in degrees a second, counter-clockwise
  std::optional<LightPath2> path = {};  // what the position follows when time passes
  friend bool operator==(const LightPlace2&, const LightPlace2&) = default;
};

}  // namespace hottel

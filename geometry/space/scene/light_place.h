// Where a light of a scene in space is, where it shines, and how it moves.
#pragma once

#include <optional>
#include <vector>

#include "geometry/space/point.h"

namespace hottel {

// A way through points at constant speed, once in so many seconds; a closed one leads back to its first point, and is
// walked over and over.
struct LightPath3 {
  std::vector<Point3> points;  // two at least, not all the same
  Rational seconds = 1;        // above 0
  bool closed = false;
  friend bool operator==(const LightPath3&, const LightPath3&) = default;
};

// One light of a scene: what Light leaves open.
struct LightPlace3 {
  Point3 position;              // of no meaning for a sun
  Vector3 direction{0, 0, -1};  // of a spot: along the axis of its beam; of a sun: of its rays; of any length, not zero
  Vector3 rotation;             // of the axis: Rz Ry Rx, each angle in degrees a second
  std::optional<LightPath3> path = {};  // what the position follows when time passes
  friend bool operator==(const LightPlace3&, const LightPlace3&) = default;
};

}  // namespace hottel

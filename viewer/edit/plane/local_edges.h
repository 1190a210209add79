// The edges of a scene in doubles, near enough to point at.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/plane/scene/scene.h"

namespace hottel {

// A place in the scene, in its own units.
using Place2 = std::array<double, 2>;

// An edge in local units.
struct LocalEdge2 {
  double from_x, from_y, to_x, to_y;
};

// The point of an edge that is nearest to a place.
struct LocalFoot2 {
  double t = 0;         // 0 at the first point, 1 at the last
  double distance = 0;  // local units
};
LocalFoot2 local_foot(const LocalEdge2& edge, const Place2& place);

// The edges of a scene as doubles, in units in which the scene is about as wide as 1 and lies at 0: coordinates of any
// size, and as far from 0 as one likes, are told apart as well as a scene near 0 is.
//
//   (1) to_local is the difference to the first point of the scene, exact, times a power of two, rounded once
// COST: two subtractions of rationals for each point of the scene, once.
class LocalEdges2 {
 public:
  explicit LocalEdges2(const Scene2& scene);

  std::span<const LocalEdge2> edges() const { return edges_; }
  // REQUIRES: finite coordinates.
  Place2 to_local(const Place2& place) const;
  // The length in local units, and back.
  double to_local(double length) const;
  double from_local(double length) const;

 private:
  Point2 origin_;
  long shift_ = 0;  // local = 2^shift_ * (coordinate - origin)
  std::vector<LocalEdge2> edges_;
};

}  // namespace hottel

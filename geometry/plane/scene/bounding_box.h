// The smallest box along the axes around points.
#pragma once

#include "geometry/plane/point.h"

namespace hottel {

struct Scene2;

// A box along the axes, its border included.
struct Box2 {
  Point2 min{0, 0}, max{0, 0};

  // The box of one point.
  static Box2 of(const Point2& point) { return {point, point}; }
  // Grows the box until the point is in it.
  void include(const Point2& point);

  Rational width() const { return max.x - min.x; }
  Rational height() const { return max.y - min.y; }
};

// Returns the box of all edges, exactly; the origin alone where there are none. COST: linear.
Box2 bounding_box(const Scene2& scene);

}  // namespace hottel

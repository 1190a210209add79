// How findings speak of places.
#pragma once

#include <string>

#include "geometry/plane/predicates/vertices.h"
#include "geometry/plane/scene/scene.h"
#include "geometry/scene_names.h"
#include "kernel/decimal.h"

namespace hottel {

// Returns a point as findings print it, each coordinate by short_text (kernel/decimal.h): "(2, 3/7)". What is printed
// of a long coordinate is near it, not exact.
inline std::string place_text(const Point2& point) {
  return "(" + short_text(point.x) + ", " + short_text(point.y) + ")";
}

// Returns the point half-way between the two ends, exactly; the order of the ends does not matter.
inline Point2 middle(const Point2& a, const Point2& b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2}; }
inline Point2 middle(const Edge2& edge) { return middle(edge.from, edge.to); }

}  // namespace hottel

// Visibility polygons as formats draw them that know straight lines only.
#pragma once

#include <optional>
#include <vector>

#include "geometry/plane/visibility/rounded_polygon.h"

namespace hottel {

// The ring or the lines that bound a region, for formats that know straight lines only.
struct DrawnPolygon2 {
  struct Vertex {
    RoundedPolygon2::Corner corner;
    std::size_t of;  // the corner of the region; the last one before it where it is a point of an arc
  };
  bool is_bounded = true;
  std::vector<std::vector<Vertex>> lines;  // bounded: one ring, its first vertex not repeated
};
// Returns how a polygon is drawn.
//
//   (1) bounded: one ring, counter-clockwise. An arc has vertices on the circle, so that no chord is farther from it
//       than a thousandth of the range
//   (2) unbounded: a line from each open side to the next; a vertex between two open sides is left out
//   (3) no corners: bounded and no line in a solid, else unbounded
DrawnPolygon2 drawn_polygon_2(const Point2& eye, const RoundedPolygon2& polygon, const std::optional<Rational>& range);

}  // namespace hottel

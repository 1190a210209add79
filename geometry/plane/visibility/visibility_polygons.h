// How visibility polygons of many points are found.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/visibility/corner_rounding.h"
#include "geometry/plane/visibility/point_location.h"
#include "geometry/plane/visibility/polygons_of_points.h"
#include "geometry/plane/visibility/rounded_polygon.h"

namespace hottel {

// Finds visibility polygons in one scene: point location and the rounding of vertices are prepared once.
//
//   (1) all() gives of() each point, in order, bit for bit the same for any number of threads
//   (2) all() throws Interrupted soon after a stop was asked for
//
// REQUIRES that the arrangement outlives it. Any number of threads may ask at once.
// COST: some µs a vertex and linear in the triangles to prepare; then for each point the view, and about 40 ns a corner
// (some 10 µs within a range).
class VisibilityPolygons2 {
 public:
  explicit VisibilityPolygons2(const Arrangement2& arrangement);

  // Throws ContractViolation where exact corners are wanted within a range, which need not be rational.
  RoundedPolygon2 of(const Point2& eye, const PolygonsOptions2& options = {}) const;
  std::vector<RoundedPolygon2> all(std::span<const Point2> eyes, const PolygonsOptions2& options = {}) const;

  // The same without the memory for a result: fills `polygon`, whose own is used again, and counts how its corners were
  // rounded.
  void look(const Point2& eye, bool wants_exact, RoundedPolygon2& polygon, RoundingCounts2& counts) const;

  // The exact area of what a point sees, in the scene's unit squared; nothing where the sky is seen, or from within a
  // solid. COST: rational arithmetic for each corner: some µs a corner.
  std::optional<Rational> area(const Point2& eye) const;

  const PointLocation2& location() const { return location_; }

 private:
  const Arrangement2& arrangement_;
  PointLocation2 location_;
  CornerRounding2 rounding_;
};

}  // namespace hottel

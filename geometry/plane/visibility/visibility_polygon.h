// What one sees from a point, exactly: the visibility polygon, the angles, and view factors from a point of a face.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/plane/arrangement/arrangement.h"
#include "geometry/plane/visibility/point_location.h"
#include "kernel/ball.h"
#include "kernel/root_sum.h"

namespace hottel {

// The region that a point sees.
//
//   (1) parts are in counter-clockwise order and their angles sum to a full turn
//   (2) a bounded part is the part of one side of one piece of the scene between two rays; its ends are exact
//   (3) area is exact, that of the free parts; nothing when the sky is seen, or from within a solid
//   (4) a part is free unless the directions to it lead into a solid: that is not seen, and no part of the polygon
//
// From a point on an edge both sides are seen; the edge itself has no angle. From a vertex, every direction is seen.
// Needles (parts of no width) belong to the closed region but not to the polygon.
struct VisibilityPolygon2 {
  struct Part {
    Point2 from, to;                       // scene coordinates; for the sky: vertices on the two bounding rays
    PieceSideId side;                      // kSky where nothing is met
    std::uint32_t solid = Solids2::kNone;  // the group that makes the solid there
  };
  Point2 eye;  // scene coordinates
  Location2 location;
  View2 view;  // what the parts are made of
  std::vector<Part> parts;
  std::optional<Rational> area;          // scene unit squared
  std::uint32_t solid = Solids2::kNone;  // the solid that the eye is in (solid_around.h)

  // Corners of the region in order, without repetition; parts that see the sky contribute their bounding vertices. The
  // eye is one where a solid begins or ends there in a corner. None from within a solid.
  std::vector<Point2> corners() const;
};

// Returns the region that a point sees; `eye` is in scene coordinates.
// REQUIRES: `location` is made of the vertices and the triangulation of the arrangement.
// COST: that of the view from the point, and rational arithmetic for each part.
VisibilityPolygon2 visibility_polygon(const Arrangement2& arrangement, const PointLocation2& location,
                                      const Point2& eye);

// Returns the angle under which a part is seen, as a fraction of the full turn, enclosed with the given precision in
// bits; 1 where it is the only part.
Ball angle_fraction(const VisibilityPolygon2& polygon, std::size_t part, long precision);

// Returns the sum of the angles of some parts as a fraction of the full turn, correctly rounded; 0 for no parts.
//
// The corners are rational, so the fraction is irrational unless it is a multiple of 1/8 (the tangent of a rational
// angle is rational only if it is 0, 1, -1 or infinite); that case is decided exactly, all others by balls.
Rounded rounded_angle_fraction(const VisibilityPolygon2& polygon, std::span<const std::size_t> parts);

// One entry of the view factors from a point of a face.
struct PointFactor2 {
  PieceSideId side;  // kSky for the sky
  RootSum factor;
};
// Returns the view factors from the point at t of the way from `from` to `to`, the ends of an edge in scene
// coordinates, of its front (right side) or its back: F(x -> g) = 1/2 sum (sin phi_end - sin phi_start), exact sums
// of square roots.
//
//   (1) the factors sum to 1, the sky included; each side of a piece that is seen has one entry
//   (2) at the first point of the edge (t = 0) and at contacts inside it the limit from larger t is taken, at t = 1
//       that from smaller t
//
// Throws ContractViolation unless 0 <= t <= 1.
// REQUIRES: from != to.
std::vector<PointFactor2> point_factors(const Arrangement2& arrangement, const PointLocation2& location,
                                        const Point2& from, const Point2& to, bool from_back, const Rational& t);

}  // namespace hottel

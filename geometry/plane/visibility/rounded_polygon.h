// The region that a point sees, with corners in doubles.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/plane/arrangement/piece_side.h"
#include "geometry/plane/point.h"

namespace hottel {

// What the sides are called that are arcs about the point (polygon_within).
inline constexpr PieceSideId kRange{-2};

// The region that one point sees, as a list of corners, counter-clockwise.
//
//   (1) corners are those of VisibilityPolygon2::corners(), in that order; each coordinate is the double nearest to the
//       exact one, ties to even
//   (2) `after` is what is seen between a corner and the next: the side of a piece (its face is the owner), kSky where
//       the region is open (the two corners are the vertices that bound the sky), kNoPiece along a ray from the point
//       or an edge at it
//   (3) from within a solid there are no corners, and `solid` is the group that makes it (solid_around.h)
//   (4) exact[k] is corner k as a rational, where that was asked for; else the list is empty
//
// Points on edges and vertices see what VisibilityPolygon2 says: both sides, every direction.
struct RoundedPolygon2 {
  struct Corner {
    double x, y;  // scene coordinates
    PieceSideId after;
    friend bool operator==(const Corner&, const Corner&) = default;
  };
  std::vector<Corner> corners;
  std::vector<Point2> exact;
  std::uint32_t solid = kNoSolid;

  bool sees_sky() const;
};

}  // namespace hottel

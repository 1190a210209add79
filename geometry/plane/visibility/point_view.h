// What a point sees, face by face: how much of the full turn each takes, or the factor from a point of a face.
#pragma once

#include <string>
#include <vector>

#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/visibility/visibility_polygon.h"
#include "geometry/scene_names.h"

namespace hottel {

// Returns the name of the face that owns a side of a piece, "wall" or "wall:back"; "sky" for kSky. Throws
// ContractViolation for a side that is covered.
std::string face_name(const Scene2& scene, const Arrangement2& arrangement, PieceSideId side);

// What a point sees of one face, of the sky, or of one solid that directions lead into.
struct SeenFrom2 {
  std::string name;                // of the face, "sky", or of the group that makes the solid
  std::vector<std::size_t> parts;  // of the polygon
  Rounded fraction;                // of the full turn, correctly rounded
};

// What a point sees.
//
//   (1) faces are in the order of first sight, counter-clockwise from where the polygon begins; solids by group
//   (2) the parts of all partition those of the polygon, the fractions of the real numbers sum to 1
//   (3) from within a solid nothing is seen: both lists are empty
struct PointView2 {
  VisibilityPolygon2 polygon;
  std::vector<SeenFrom2> faces, solids;
};
// Returns what a point sees, in scene coordinates; it may lie on edges and vertices. COST: linear in the triangles,
// for the point location that is made for it.
PointView2 point_view(const PreparedScene2& prepared, const Point2& eye);

// The exact view factor from a point of a face to another face or the sky.
struct FaceFactor2 {
  std::string to;
  RootSum factor;
};
// Returns the view factors from the point at t of the way along a face, one entry a face that is seen: point_factors
// summed by faces, in the order of first sight.
// REQUIRES: 0 <= t <= 1. COST: as point_view.
std::vector<FaceFactor2> point_factors_by_face(const PreparedScene2& prepared, const Face& face, const Rational& t);

}  // namespace hottel

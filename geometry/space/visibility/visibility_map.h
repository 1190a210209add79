// What one sees from a point of space, exactly: convex cones of directions, each with the face seen in it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/face.h"
#include "geometry/space/arrangement/occluders.h"
#include "geometry/space/point.h"
#include "geometry/space/visibility/direction.h"
#include "geometry/space/visibility/eye_plane.h"

namespace hottel {

// From where to look, and where to.
struct Look3 {
  Point3 eye;                    // scene coordinates; any point
  std::optional<Point3> normal;  // not zero, of any length: only the half space that it points into is seen
  bool always_exact = false;     // settle all signs along planes by integers, to test the filter
};

// The map of what is seen from a point.
//
//   (1) the cones of two fragments have no common inner direction, and in each inner direction of a fragment its face
//       is what is met first: exactly, by signs of integers
//   (2) a fragment is a convex cone, less than a half space: its corners in order, inside on the side `side` of the
//       plane of each; the edge on the plane of a corner ends at the next corner
//   (3) directions and points are rounded: directions to 1e-12 at worst, and to the last digits as a rule; fractions
//       and factors to some 1e-16 for each fragment, absolutely
//   (4) the fractions of the shares and the sky sum to 1, or to 1/2 in a half space; the factors of the shares and the
//       sky's to 1: by definition of the sky's, which are the rest. In a closed room they are below 5e-15
//   (5) signs, fragments, directions and fractions do not depend on translation, nor on the unit of length; nothing
//       depends on threads
//
// Polygons are opaque on both sides; what is seen is the side towards the eye. They hide and are seen as open sets:
// where they only touch, or one hides a null set of another, nothing is lost. A polygon in whose plane the eye lies has
// no solid angle: it hides nothing and is not seen. So an eye on a face sees both half spaces, and within a wall of
// boxes that meet there, what the boxes leave; in the edge or corner of a room it sees what is not in those planes.
struct VisibilityMap3 {
  struct Corner {
    Direction3 direction;
    double x, y, z;   // where the face is met, scene coordinates
    PlaneSide3 side;  // its plane is one of `planes`
  };
  struct Fragment {
    Face face;
    std::uint32_t begin, end;  // in corners
    double fraction, factor;   // as Share
  };
  struct Share {
    Face face;
    double fraction;  // of the full sphere
    double factor;    // view factor from the point to the face: where there is a normal, else 0
  };

  std::vector<Corner> corners;
  std::vector<Fragment> fragments;       // by face
  std::vector<Share> shares;             // of the faces that are seen, in order
  std::vector<PlaneDefinition3> planes;  // those that fragments have
  double sky_fraction = 0, sky_factor = 0;
  SignCounts signs;

  // What leads into solids, from a point of their border (outside_solids of seen_faces.h; else none): fragments, whose
  // faces are what is met there, and what of the full sphere these are in all, by ClosedMesh3.
  struct InSolid {
    std::uint32_t mesh;
    double fraction;
  };
  std::vector<Fragment> solid_fragments;
  std::vector<InSolid> solids;
};

// Returns the map of what is seen from a point.
//
// Throws ContractViolation where the normal is zero.
// COST: 2 to 3 microseconds a polygon in rooms full of boxes.
// SEE: docs/design/space/visibility_map.md.
//
// For several threads at once.
VisibilityMap3 map_from(const Occluders3& occluders, const Look3& look);

// Returns the map of what a sun sees, by the direction of its rays.
//
//   (1) as map_from(), with the directions of SunFrame3 in place of those from the eye: the corners of fragments are
//       such directions, and a polygon along whose plane the rays run hides nothing and is not seen
//   (2) there are no angles, and where faces are met is left to ExactVisibilityMap3::corners_on_face(): fractions,
//       factors and the places of corners are 0
//
// Throws ContractViolation where the direction is zero. COST: that of map_from().
VisibilityMap3 map_of_sun(const Occluders3& occluders, const Vector3& direction);

}  // namespace hottel

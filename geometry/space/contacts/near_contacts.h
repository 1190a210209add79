// Surfaces in space that all but touch.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/space/scene/scene.h"

namespace hottel {

// How near is near: closer than this part of the width of the narrowest surface that takes part (squared_width). It
// decides only what is worth telling.
inline constexpr int kNearPart3 = 1024;

// A corner that is near a surface without touching it, or two edges that pass by each other. All places are exact, in
// scene coordinates.
struct NearContact3 {
  enum class Kind : unsigned char { kCornerCorner, kCornerEdge, kCornerFace, kEdgeEdge };
  Kind kind = Kind::kCornerFace;
  std::vector<std::uint32_t> surfaces;  // that have the corner, or the first edge, ascending
  std::vector<std::uint32_t> targets;   // that have the corner, edge or face that is near, ascending
  Point3 from, to;                      // their nearest points, the first on `surfaces`
  Rational squared;                     // the distance, > 0
  bool sticks_out = false;  // an edge that ends at the corner crosses the target: nothing passes between the two
  bool is_angle = false;    // each of `surfaces` has an edge in common with a target: they make an angle
};

// A corner that lies inside an edge of surfaces that do not have it as a corner: a T-junction.
struct Junction3 {
  Point3 at;
  std::vector<std::uint32_t> ends, through;  // ascending
};

// Two surfaces that pass through each other: an edge of the one meets the inside of the other.
struct Crossing3 {
  Point3 at;
  std::uint32_t surface = 0, through = 0;
};

// What surfaces of a scene do to each other where they have no corner in common.
//
//   (1) each near contact is nearer than 1 / kNearPart3 of the width of each surface that takes part: of those at the
//       corner and of the targets; of one of either of two edges. Exactly, and whatever the scale
//   (2) at most one for each corner, the nearest; a corner less than sqrt(2) times as far counts as nearest, and of two
//       corners that are near each other the pair is told once; edges where no corner of them is near the other
//   (3) a corner lies inside an edge of t without being one of its corners iff a junction has t in `through`
//   (4) of the surfaces of two groups that cross, or those of one, one crossing is told
struct Contacts3 {
  std::vector<NearContact3> near;
  std::vector<Junction3> junctions;
  std::vector<Crossing3> crossings;
};

// Nearly plane polygons are their facets. Patches touch nothing: what they lie on does. COST: O(n log n), and exact
// arithmetic for what doubles find near: 10^4 polygons of a room take about a second.
Contacts3 find_contacts(const Scene3& scene);

}  // namespace hottel

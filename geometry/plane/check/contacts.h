// Where the surfaces of a scene touch, cross and cover each other.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/plane/arrangement/arrangement.h"
#include "geometry/plane/check/face_cover.h"
#include "geometry/plane/scene/scene.h"

namespace hottel {

// Surfaces that cross: `at` lies inside each of them, and they do not all lie on one line.
struct Crossing2 {
  Point2 at;
  std::vector<std::uint32_t> surfaces;
  bool is_in_solid = false;  // all around is
};

// Surfaces that end inside others which lie on another line: a T-junction, or several at one point.
struct Junction2 {
  Point2 at;
  std::vector<std::uint32_t> ends, through;
  bool is_in_solid = false;
};

// What is on one side of a stretch: a solid that covers it, or those who claim it.
struct OverlapSide2 {
  std::uint32_t solid = Solids2::kNone;  // the group that makes it
  SideOwner2 claims{};                   // REQUIRES no solid
};

// A stretch that the same two or more surfaces cover, with the same on each side.
struct Overlap2 {
  Point2 from, to;
  std::vector<PieceSource2> covering;  // is_reversed against from -> to
  std::array<OverlapSide2, 2> sides;   // left, right
};

// Every contact but common end points.
//
//   (1) surfaces s and t that are not parallel have a point inside both iff some crossing lists both
//   (2) an end of s lies inside t, not parallel to s, iff some junction lists s in `ends` and t in `through`
//   (3) s and t share a length iff some overlap lists both; overlaps do not overlap, and are as long as can be
//   (4) surface lists ascend; `duplicates` are the sets of two or more surfaces with the same two end points
//   (5) `faces` is what the arrangement of the scene leaves of each face
struct Contacts2 {
  std::vector<Crossing2> crossings;
  std::vector<Junction2> junctions;
  std::vector<Overlap2> overlaps;
  std::vector<std::vector<std::uint32_t>> duplicates;
  FaceCover2 faces;
};

// Returns the contacts of a scene, all of them decided exactly.
// REQUIRES: the arrangement of the undivided scene; conflicts may be kept.
// COST: O(n log n) for n pieces.
Contacts2 find_contacts(const Scene2& scene, const Arrangement2& arrangement);
// The same with an arrangement of its own. Throws InputError for a "behind" that cannot be obeyed.
Contacts2 find_contacts(const Scene2& scene);

}  // namespace hottel

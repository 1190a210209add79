// Where the surfaces of a scene touch, cross and cover each other.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/arrangement/claims_2.h"
#include "geometry/scene/scene_2.h"

namespace hottel {

// Surfaces that cross: `at` lies inside each of them, and they do not all lie on one line.
struct Crossing2 {
  Point2 at;
  std::vector<std::uint32_t> surfaces;
};

// Surfaces that end inside others which lie on another line.
struct Junction2 {
  Point2 at;
  std::vector<std::uint32_t> ends, through;
};

// A stretch that the same two or more surfaces cover.
struct Overlap2 {
  Point2 from, to;
  std::vector<PieceSource2> covering;  // is_reversed against from -> to
};

// Every contact but common end points.
//
//   (1) surfaces s and t that are not parallel have a point inside both iff some crossing lists both
//   (2) an end of s lies inside t, not parallel to s, iff some junction lists s in `ends` and t in `through`
//   (3) s and t share a length iff some overlap lists both; overlaps do not overlap, and are as long as can be
//   (4) surface lists ascend; `duplicates` are the sets of two or more surfaces with the same two end points
//   (5) has_area[2 s] ([2 s + 1]) says whether the front (back) of s owns a side of a piece, by the claims rule, or
//       is one of two that claim it
struct Contacts2 {
  std::vector<Crossing2> crossings;
  std::vector<Junction2> junctions;
  std::vector<Overlap2> overlaps;
  std::vector<std::vector<std::uint32_t>> duplicates;
  std::vector<char> has_area;
};

// COST: an overlay (geometry/arrangement/overlay_2.h), then O(n log n) for n pieces.
Contacts2 find_contacts(const Scene2& scene);

}  // namespace hottel

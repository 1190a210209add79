// What is solid in a scene, read off the text of the contract. Rational coordinates, nothing shared with what it
// checks.
#pragma once

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

#include "tests/oracle/plane/input_segment.h"
#include "tests/oracle/plane/regions.h"

namespace hottel::oracle {

// An edge that lies on a piece.
struct Lying {
  std::size_t edge;
  bool is_forwards;  // runs like the piece, from the smaller point to the larger
};

// What is solid, and why.
//
//   (1) a closed group without any back material whose winding number is 0 or 1 in every region encloses those where it
//       is 1, less those where the winding number of a room in it is -1. A room is a closed group with winding number 0
//       or -1 everywhere; it lies in the group if each of its walls, seen from inside it, does
//   (2) a group with Behind::kSolid makes solid also the bounded regions that a back of it without material looks into
//       and none of its fronts. With Behind::kOpen it makes none solid
//   (3) a region is solid iff some group makes it so
struct Solids {
  std::vector<std::set<std::size_t>> makers;                     // by region: the groups that make it solid
  std::vector<std::size_t> unbounded;                            // groups that say solid, and no region is behind them
  std::set<std::pair<std::size_t, std::size_t>> contradictions;  // groups that say solid and open of one region
  bool has_room = false;                                         // in a building
};

Solids solids_of(const std::vector<InputSegment>& edges, const Regions& regions,
                 const std::vector<std::vector<Lying>>& lying_on_pieces);

// Returns whether a scene has groups that may make something solid.
bool may_have_solids(const std::vector<InputSegment>& edges);

}  // namespace hottel::oracle

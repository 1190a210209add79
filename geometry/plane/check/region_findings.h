// What is worth telling about rooms: the bounded regions of free space.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/plane/arrangement/free_regions.h"
#include "geometry/plane/check/finding.h"
#include "geometry/plane/prepared/prepared_scene.h"

namespace hottel {

// Kinds: inside-out, isolated-cell, spans-rooms. Solid regions are no rooms.
//
//   inside-out      every wall of a room turns its black back to surfaces that stand in the room; or a closed polyline
//                   that stands in a room turns its black backs to the room and its fronts to an inside without light
//   isolated-cell   a room that exchanges light with no other, when there are several
//   spans-rooms     one face stands in several rooms: it has one radiosity, so light gets from one to the other by it
struct RegionFindings2 {
  Findings2 findings;
  // Surfaces of the inside-out ones that lose nothing when they are reversed: their fronts see nothing but the sky,
  // each other and black backs, without light.
  std::vector<std::vector<std::uint32_t>> certainly_reversed;
  std::vector<char> is_inside_out;  // by surface: told of as inside-out, for its black back
};
// REQUIRES: the regions of the arrangement of `prepared`.
RegionFindings2 region_findings(const PreparedScene2& prepared, const FreeRegions2& regions);

}  // namespace hottel

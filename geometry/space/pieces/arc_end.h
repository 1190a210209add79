// The ends of the arcs that bound what is seen, as names. Internal to geometry/space/exchange.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/space/visibility/eye_plane.h"

namespace hottel {

// Where an arc of the boundary of what is seen begins or ends: a corner of a plane.
struct ArcEnd3 {
  PlaneId3 plane;
  std::uint64_t label;  // of the corner: equal for equal definitions
  int count;            // how often arcs on the plane end here, less how often they begin
  friend bool operator==(const ArcEnd3&, const ArcEnd3&) = default;
};

// The same in few bytes, some five an end.
//
//   (1) unpacked_ends_3(packed_ends_3(ends)) == ends
//
// REQUIRES that they are sorted by plane.
std::vector<unsigned char> packed_ends_3(std::span<const ArcEnd3> ends);
std::vector<ArcEnd3> unpacked_ends_3(std::span<const unsigned char> bytes);

}  // namespace hottel

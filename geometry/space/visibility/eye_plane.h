// What a plane through an eye is, exactly.
#pragma once

#include <cstdint>

#include "kernel/support/id.h"

namespace hottel {

using PlaneId3 = Id<struct PlaneTag3>;

// A plane with a side: directions w with m . w > 0, where m is the normal of the plane, or its opposite.
struct PlaneSide3 {
  PlaneId3 plane;
  bool is_opposite = false;

  PlaneSide3 opposite() const { return {plane, !is_opposite}; }
  friend bool operator==(const PlaneSide3&, const PlaneSide3&) = default;
};

// What defines a plane through the eye x, and with it its normal m, up to a positive factor.
//   kEdge:     m = (a - x) x (b - x) for vertices a < b, the ends of an edge
//   kCrossing: m . w > 0 exactly for the directions in which the plane of polygon a is met before that of polygon b,
//              among those in which both are met
//   kHorizon:  m is given
struct PlaneDefinition3 {
  enum class Kind : unsigned char { kEdge, kCrossing, kHorizon };
  Kind kind = Kind::kEdge;
  std::uint32_t a = 0, b = 0;
};

}  // namespace hottel

// The direct exchange area of two straight edges alone in the plane: Hottel's crossed strings, clipped where needed.
#pragma once

#include <optional>

#include "geometry/plane/arrangement/overlay.h"
#include "geometry/plane/predicates/vertices.h"
#include "kernel/root_sum.h"
#include "kernel/rounding.h"

namespace hottel {

// True iff S0 > 0: a part of each lies in front of the other. Symmetric; false for two on one line. Exact.
// COST: four orientations.
bool face_each_other(const Vertices2& vertices, const Segment2& f, const Segment2& g);

// Returns 2 S0 of the fronts (right sides) of f and g when nothing else stands in the plane, in units of
// Vertices2::fixed_unit(). Nothing when the two cross each other properly: the crossing is then no end of either, and
// only the exact form knows it.
//
//   (1) symmetric in f and g, and 0 when one lies behind the other or both lie on one line
//   (2) an integer combination of distances between the four end points: where the line of g cuts f outside g, the
//       strings to the cut differ by exactly |g|
//   (3) its error is length_error() for each distance that is not exact
//
// COST: four orientations and at most four distances.
// SEE: Hottel's crossed strings.
std::optional<FixedSum> unobstructed_sum(const Vertices2& vertices, const Segment2& f, const Segment2& g);

// The same, exactly, in integer form, crossings included.
RootSum unobstructed_exact(const Vertices2& vertices, const Segment2& f, const Segment2& g);

}  // namespace hottel

// Parts of stretches: in doubles, and inside a polygon. Internal to geometry/space/exchange.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/space/stretches/stretch.h"
#include "geometry/space/visibility/direction.h"

namespace hottel {

inline WeightedPoint3 end_of(const Stretch3& stretch) { return {sum(stretch.from, stretch.way), stretch.weight}; }

// Where a stretch is at t = low and t = high, in doubles of integer form times 2^-shift.
std::array<Direction3, 2> ends_in_doubles(const Stretch3& stretch, double low, double high, long shift);

// From where to where (t) a stretch in the plane of a convex polygon is inside it; nothing where that is nowhere, or on
// its border alone. `normal`: of the side from which the corners run counter-clockwise.
std::optional<std::array<Rational, 2>> part_inside(const Stretch3& stretch, const std::vector<WeightedPoint3>& corners,
                                                   const IntegerVector& normal);

}  // namespace hottel

// Where a ring crosses itself.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/plane/point.h"

namespace hottel {

// Two sides of a ring that cross. Side k runs from point k to the next one, the last side to the first point.
struct RingCrossing2 {
  std::size_t first = 0, second = 0;  // sides; first < second
  Point2 at;
};

// Returns the first crossing of a ring with itself, by its sides; nothing where there is none.
//
//   (1) sides cross in a point that is inside of both; a ring that touches itself, passes twice through one of its
//       points, or runs back along itself does not cross itself by that
//   (2) exact, for points of any size
//
// COST: O(n log n + k) for k pairs of sides whose bounding boxes meet.
std::optional<RingCrossing2> find_ring_crossing(const std::vector<Point2>& ring);

}  // namespace hottel

#include "geometry/space/between/stopped_lines.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace hottel {
namespace {

// Whether the line from p to q passes on one and the same side of all sides of a body, on none of them.
bool passes_within(const PairGeometry3& bodies, std::uint32_t p, std::uint32_t q, std::uint32_t body) {
  const std::vector<std::uint32_t>& corners = bodies.bodies[body].corners;
  const int first = bodies.orientation(p, q, corners.back(), corners.front());
  if (first == 0) return false;
  for (std::size_t k = 0; k + 1 < corners.size(); ++k)
    if (bodies.orientation(p, q, corners[k], corners[k + 1]) != first) return false;
  return true;
}

}  // namespace

bool stops_lines_of_corners(const PairGeometry3& bodies, std::uint32_t body) {
  for (const std::uint32_t p : bodies.bodies[0].corners) {
    const int before = bodies.side(p, body);
    if (before == 0 || bodies.side(p, 1) <= 0) continue;
    for (const std::uint32_t q : bodies.bodies[1].corners)
      if (bodies.side(q, body) == -before && bodies.side(q, 0) > 0 && passes_within(bodies, p, q, body)) return true;
  }
  return false;
}

}  // namespace hottel

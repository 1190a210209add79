// What the corners of what is seen from a stretch are of. Internal to geometry/space/exchange.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace hottel {

// A direction in which what is seen has a corner: to a point, or where two planes through the eye meet, each through an
// edge, or through where surfaces meet each other. Points and bodies are those of PairGeometry3.
struct SightCorner3 {
  std::uint64_t label = 0;                          // equal for equal corners of one pair
  std::optional<std::uint32_t> point;               // else:
  std::vector<std::array<std::uint32_t, 2>> edges;  // the ends of each
  std::vector<std::uint32_t> bodies;                // whose own plane it is, or where two of them cross
};

}  // namespace hottel

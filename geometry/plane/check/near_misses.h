// Ends of surfaces that all but touch something.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/plane/scene/scene.h"

namespace hottel {

// How near is near: closer than this part of the shortest surface that takes part. It decides only what
// is worth telling.
inline constexpr int kNearPart = 1024;

// An end of surfaces that is near another surface without touching it. All places are exact, in scene coordinates.
struct NearMiss2 {
  Point2 tip;                           // where surfaces end
  std::vector<std::uint32_t> surfaces;  // those, ascending
  std::uint32_t target = 0;             // the surface that is near
  Point2 foot;                          // its nearest point
  bool is_at_end = false;               // the foot is an end of the target
  bool sticks_out = false;              // a surface of the tip crosses the target: nothing passes between tip and foot
  Rational squared_distance;            // of tip and foot, > 0
};

// Returns the near misses of a scene.
//
//   (1) each is nearer than 1 / kNearPart of the shortest surface that ends at the tip and of the target (of all
//       surfaces that end at the foot when it is an end); exactly, and whatever the scale
//   (2) at most one for each end point: the nearest; of two ends that are near each other, the pair is told once
//   (3) surfaces that meet the tip, or that touch one that does, are no targets: they make angles. What crosses one
//       that ends at the tip is: the tip sticks out
//   (4) patches are near nothing: what they lie on is
// COST: O(n log n) and exact arithmetic for surfaces whose bounding box is near an end point.
std::vector<NearMiss2> find_near_misses(const Scene2& scene);

}  // namespace hottel

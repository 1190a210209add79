// Where a point lies in a scene, in words of the scene.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/plane/point.h"

namespace hottel {

struct PreparedScene2;

// Where a point lies.
//
//   (1) exact: on a surface means exactly on it, its end points included
//   (2) in a solid means in the interior of the union of all solids; a point on its border is in none (solid_around.h)
//   (3) sees_sky: some direction from the point leads into the open. False in a solid
struct PointPlace2 {
  std::vector<std::uint32_t> surfaces;  // that the point lies on, ascending
  std::optional<std::uint32_t> solid;   // the first listed group that makes a solid there
  bool sees_sky = false;
};

// Returns where a point of scene coordinates lies. COST: linear in the scene, some 0.1 µs a surface.
PointPlace2 place_of(const PreparedScene2& prepared, const Point2& point);

}  // namespace hottel

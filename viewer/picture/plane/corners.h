// Where the edges of a scene lie in a picture, and which of them meet.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/plane/scene/scene.h"
#include "viewer/picture/canvas.h"
#include "viewer/picture/plane/frame.h"

namespace hottel {

// The end points of all surfaces, equal ones once.
//
//   (1) from[i] == to[j] exactly when surface i begins at the very point where j ends: decided on the exact coordinates
//   (2) at[from[i]] is where surface i begins in the picture
struct Corners2 {
  std::vector<Pixel> at;
  std::vector<std::uint32_t> from, to;  // per surface

  Corners2() = default;
  // COST: O(n log n).
  Corners2(const Scene2& scene, const Frame2& frame);

  std::size_t surfaces() const { return from.size(); }
};

}  // namespace hottel

// Item buffers: which element shows in each pixel of half a cube about a patch.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "solver/space/methods/element_geometry.h"
#include "solver/space/methods/side_elements.h"

namespace hottel {

// One side of half a cube about the centre of a patch: a camera there. A direction out + x right + y up is on it where
// -1 <= x <= 1 and -1 <= y <= 1, on the four sides that are cut by the plane of the patch 0 <= y.
struct CubeSide3 {
  Vector3d right, up, out;
  std::uint32_t first_row = 0;  // of as many rows as columns, from the lowest y up

  Vector3d seen(const Vector3d& way) const { return {dot(way, right), dot(way, up), dot(way, out)}; }
};

// The top, and then the four sides.
std::array<CubeSide3, 5> sides_over_3(const ElementPatch3& patch, std::uint32_t resolution);

// Calls draw(corners, label) for all items that turn a side to the centre of the patch, by their corners as a side of
// the cube sees them, counter-clockwise for the eye. The piece of the patch is none.
template <class Draw>
void for_items_3(const ElementPatch3& patch, const CubeSide3& side, const SideElements3& items, const Draw& draw) {
  thread_local std::vector<Vector3d> seen;
  for (std::uint32_t number = 0; number < items.all().size(); ++number) {
    if (Face::of(number).surface == patch.piece) continue;
    for (const SidePart3& item : items.all()[number]) {
      const auto& corners = item.corners;
      const Vector3d out = cross(corners[1] - corners[0], corners[2] - corners[0]);
      if (!(dot(out, corners[0] - patch.centre) < 0)) continue;  // seen from behind
      seen.clear();
      for (std::size_t k = corners.size(); k-- > 0;) seen.push_back(side.seen(corners[k] - patch.centre));
      draw(std::span<const Vector3d>(seen), item.label);
    }
  }
}

// What one side shows, pixel by pixel. Pixel (column, row) stands for its centre, x = (2 column + 1 - R) / R and
// y = (2 row + 1 - R) / R.
//
//   (1) a pixel shows the item that is nearest in the direction of its centre, `background` where there is none
//   (2) items are numbered by 32 bits: no batches are needed
class ItemBuffer3 {
 public:
  virtual ~ItemBuffer3() = default;
  ItemBuffer3() = default;
  ItemBuffer3(const ItemBuffer3&) = delete;
  ItemBuffer3& operator=(const ItemBuffer3&) = delete;

  // Returns the labels of the rows from side.first_row on, row by row; valid until the next call. One thread at a time.
  virtual std::span<const std::uint32_t> draw(const ElementPatch3& patch, const CubeSide3& side,
                                              const SideElements3& items, std::uint32_t background) = 0;
};

// In software, in doubles: of two items that share an edge one and only one covers a centre on it.
std::unique_ptr<ItemBuffer3> software_item_buffer_3(std::uint32_t resolution);

// By OpenGL 4.5, on whatever EGL has: a graphics processor, or Mesa's own rasteriser. It may differ from the one in
// software on pixels whose centre lies within 2^-7 of a pixel of an edge, or whose two items are equally far within
// 2^-20 of their distance; which these are is the driver's.
// Throws RequestError where there is no such OpenGL, or where this program was built without EGL.
std::unique_ptr<ItemBuffer3> gl_item_buffer_3(std::uint32_t resolution);

}  // namespace hottel

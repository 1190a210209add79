// The elements on the sides of the pieces of a scene, as approximate methods meet them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/face.h"
#include "solver/space/methods/element_geometry.h"

namespace hottel {

// Part of a side of a piece, with its corners counter-clockwise for who sees it.
struct SidePart3 {
  std::uint32_t label;  // of its element
  std::vector<Vector3d> corners;
};

// What is seen where a side of a piece is met: all of it belongs to some element; what solids cover is told by its
// owner too, and never met.
class SideElements3 {
 public:
  SideElements3(const PreparedScene3& prepared, const ElementTable3& table) : sides_(2 * prepared.occluders().size()) {
    for (const ElementTable3::Part& part : table.parts())
      if (!part.patch.is_sky())
        sides_[Face{part.patch.surface, part.is_back}.number()].push_back(
            {part.label, rounded_corners(prepared.occluders().vertices(), part.patch)});
  }

  // side: of a piece. Empty where a solid covers all of it.
  std::span<const SidePart3> on(const Face& side) const { return sides_[side.number()]; }
  // By number of the side.
  const std::vector<std::vector<SidePart3>>& all() const { return sides_; }

 private:
  std::vector<std::vector<SidePart3>> sides_;
};

}  // namespace hottel

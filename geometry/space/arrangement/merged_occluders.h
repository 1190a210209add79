// Polygons of one plane that share an edge, taken as one. Internal to geometry/space.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/space/arrangement/occluders.h"

namespace hottel {

// Occluders of which neighbours in one plane are one surface where their union is convex: the triangles of a box are
// six quads. They hide what the polygons hide, with half the edges or fewer, and nothing meets at edges that are none.
//
//   (1) each polygon is within one surface, each surface is the union of its members(): two whose fronts face the same
//       way are one where they share all of an edge and their union is convex, and so on until no two are left
//   (2) surfaces are in the order of their first members; vertices keep their numbers and coordinates
//   (3) the choice depends on the order of the polygons and on signs alone, not on where the scene lies or its unit
//
// REQUIRES: the polygons outlive this, and no two of them share an area of one plane.
// COST: O(n log n); some microseconds a polygon.
class MergedOccluders3 {
 public:
  explicit MergedOccluders3(const Occluders3& polygons);

  // Those given where none are merged: is_plain().
  const Occluders3& occluders() const { return merged_ ? *merged_ : polygons_; }
  bool is_plain() const { return !merged_; }
  std::uint32_t surface_of(std::uint32_t polygon) const { return surface_of_[polygon]; }
  // Ascending.
  std::span<const std::uint32_t> members(std::uint32_t surface) const { return members_[surface]; }

 private:
  const Occluders3& polygons_;
  std::vector<std::uint32_t> surface_of_;
  std::vector<std::vector<std::uint32_t>> members_;
  std::optional<Occluders3> merged_;
};

}  // namespace hottel

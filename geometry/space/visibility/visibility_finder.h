// Whether points are seen from a point, many of them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/space/point.h"
#include "geometry/space/visibility/exact_visibility_map.h"

namespace hottel {

// Finds points in the map of an eye.
//
//   (1) sees(p) is true iff the segment from the eye to p is free. A polygon hides p where it crosses the segment
//       between both ends; what has directions as near as one likes that are not hidden, up to the distance of p, is
//       free: polygons are met as open sets, and two that share an edge have no gap there
//   (2) a polygon on which p lies, or in whose plane the eye is, does not hide it. An eye sees itself
//   (3) exact, by signs of integers and rationals
//
// For several threads at once. REQUIRES that the map outlives this.
// COST: to make it some milliseconds for a thousand fragments; then some microseconds a point, for any number of
// polygons as long as fragments are not all around one direction.
class VisibilityFinder3 {
 public:
  explicit VisibilityFinder3(const ExactVisibilityMap3& map);

  bool sees(const Point3& point) const;

 private:
  std::span<const std::uint32_t> near(const IntegerVector& direction) const;

  const ExactVisibilityMap3& map_;
  std::size_t cells_;                 // along each edge of the faces of a cube around the eye
  std::vector<std::uint32_t> first_;  // of each cell in fragments_
  std::vector<std::uint32_t> fragments_;
};

}  // namespace hottel

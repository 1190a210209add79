// Where the values of elements are blended, and what they are there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/space/point.h"
#include "viewer/picture/space/hanging_corners.h"

namespace hottel {

class ElementTable3;
struct PreparedScene3;

// The corners of the elements of a scene, for values that run smoothly over a flat surface.
//
// A flat surface is one side of a polygon; or of all polygons of one group (mesh) that lie in one plane, look the same
// way and have materials that act alike. A polygon that is plane only nearly is as many flat surfaces as it has planes.
//
//   (1) corners are told apart exactly. A corner that lies within the side of a neighbour is in its ring too, so that
//       both are blended between the same values along their common side: nothing jumps there
//   (2) the value at a corner is the mean of the elements that meet there on the flat surface, by their areas
//   (3) but where it hangs, within the side of a coarser element, that between the values at the ends of that side;
//       of several sides it is the longest one's. So each element's values are linear along each of its sides. Where
//       sides lead round in a circle (in_order) their corners keep the mean: of staggered divisions of neighbours, and
//       of bricks laid as a pinwheel, never of one polygon
//   (4) a part is blended between its middle, which has the value of its element, and its ring, in triangles. So what
//       is equal all over stays so, exactly, and nothing leaves the range of the elements
//   (5) nothing is blended across an edge of the scene, or between surfaces: corners on it have the mean of what is on
//       their side
//
// COST: some microseconds a corner, and for each side those of the flat surface that are as far along one axis.
class SmoothMesh3 {
 public:
  // REQUIRES the table of the scene by faces or elements.
  SmoothMesh3(const PreparedScene3& prepared, const ElementTable3& table);

  const std::vector<Point3>& corners() const { return corners_; }
  // The corners of a part of the table in order, those in its sides included; none where all of its flat surface is one
  // element, and of the sky.
  std::span<const std::uint32_t> ring(std::size_t part) const {
    return std::span(ring_).subspan(begin_[part], begin_[part + 1] - begin_[part]);
  }

  // Those that take their value from a coarser side, in order.
  const std::vector<HangingCorner3>& hanging() const { return hanging_; }

  // Returns values by corner and channel; of elements that are NaN nothing is taken, and where there are no others it
  // is NaN.
  std::vector<double> at_corners(std::span<const double> by_element, std::size_t channels) const;

 private:
  class Builder;

  std::vector<Point3> corners_;
  std::vector<std::size_t> begin_;      // by part
  std::vector<std::uint32_t> ring_;     // corners
  std::vector<std::size_t> first_;      // by corner
  std::vector<std::uint32_t> meeting_;  // elements
  std::vector<double> area_;            // by element
  std::vector<HangingCorner3> hanging_;
};

}  // namespace hottel

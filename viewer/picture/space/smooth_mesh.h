// Where the values of elements are blended, and which share a corner.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/space/point.h"

namespace hottel {

class ElementTable3;
struct PreparedScene3;

// The corners of the elements of a scene, for values that run smoothly over a flat surface.
//
// A flat surface is one side of a polygon; or of all polygons of one group (mesh) that lie in one plane, look the same
// way and have materials that act alike. A polygon that is plane only nearly is as many flat surfaces as it has planes.
//
//   (1) corners are told apart exactly. A corner that lies in the side of a neighbour is a corner of that neighbour
//   too,
//       so that both are blended between the same values along their common side: there is no crack
//   (2) the value at a corner is the mean of those of the elements around it on the flat surface, by their angles there
//   (3) a part is blended between its middle, which has the value of its element, and its corners, in triangles. So
//       what is equal all over, or linear around, stays so
//   (4) nothing is blended across an edge of the scene, or between surfaces
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

  // Returns values by corner and channel; of elements that are NaN nothing is taken.
  std::vector<double> at_corners(std::span<const double> by_element, std::size_t channels) const;

 private:
  class Builder;

  std::vector<Point3> corners_;
  std::vector<std::size_t> begin_;      // by part
  std::vector<std::uint32_t> ring_;     // corners
  std::vector<double> angle_;           // beside ring_
  std::vector<std::uint32_t> element_;  // by part
};

}  // namespace hottel

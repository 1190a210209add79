// Chosen points on all runs of a scene, and which of them see each other.
#pragma once

#include <vector>

#include "geometry/plane/visibility/segment_visibility.h"
#include "solver/plane/methods/element_geometry.h"

namespace hottel {

// The same chosen places on every run, as exact points, and which of them see each other.
//
//   (1) see_each_other() is decided without rounding
class RunPoints2 {
 public:
  // The points run.at(t) of every run, for each t of `places`. REQUIRES 0 < t < 1; that both outlive this.
  // COST: some µs a point, in parallel.
  RunPoints2(const PreparedScene2& prepared, const ElementGeometry2& geometry, const std::vector<Rational>& places);

  // Whether point k of run a and point l of run b see each other (geometry/plane/visibility/segment_visibility.h).
  bool see_each_other(const ElementRun2& a, std::size_t k, const ElementRun2& b, std::size_t l) const {
    return visibility_.see_each_other(points_[geometry_.number_of(a)][k], points_[geometry_.number_of(b)][l]);
  }

  // Appends the elements that are seen from the points of all runs of an element, each once or more: among them all
  // elements with points that one of these points sees. COST: one look around for each point of the element.
  void append_partners(std::uint32_t element, std::vector<std::uint32_t>& elements) const;

 private:
  const ElementGeometry2& geometry_;
  SegmentVisibility2 visibility_;
  std::vector<std::vector<RunPoint2>> points_;  // by run
};

}  // namespace hottel

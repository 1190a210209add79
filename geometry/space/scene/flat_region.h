// Points of a plane by two coordinates, and regions of it.
#pragma once

#include <array>
#include <vector>

#include "kernel/rational.h"

namespace hottel {

// A point of a plane by two of its coordinates, exactly.
struct FlatPoint3 {
  Rational u, v;
  friend bool operator==(const FlatPoint3&, const FlatPoint3&) = default;
};
using FlatSegment3 = std::array<FlatPoint3, 2>;  // of two different points

// Twice the area of the triangle a, b, c: positive where it goes around counter-clockwise.
Rational doubled_area(const FlatPoint3& a, const FlatPoint3& b, const FlatPoint3& c);
// The same of a loop: of one that goes around several times, each counts.
Rational doubled_area(const std::vector<FlatPoint3>& loop);

// Closed lines of a plane, and what is inside: the points that a ray leaves across an odd number of sides.
class FlatRegion3 {
 public:
  FlatRegion3() = default;
  explicit FlatRegion3(std::vector<std::vector<FlatPoint3>> loops);

  const std::vector<std::vector<FlatPoint3>>& loops() const { return loops_; }
  void append_sides(std::vector<FlatSegment3>& segments) const;
  // REQUIRES a point that is not on a side. COST: linear.
  bool contains(const FlatPoint3& point) const;
  bool is_on_border(const FlatPoint3& point) const;
  bool may_meet(const FlatRegion3& other) const;  // their closed boxes do

 private:
  std::vector<std::vector<FlatPoint3>> loops_;
  FlatPoint3 low_, high_;
};

// Returns what two convex polygons have in common, both counter-clockwise; no points where that has no area. No three
// points in a row are on one line.
std::vector<FlatPoint3> common_part(const std::vector<FlatPoint3>& a, const std::vector<FlatPoint3>& b);

// True iff a segment, or the inside of a convex polygon, has a point within a convex polygon, borders left out. Both
// polygons are counter-clockwise; a segment has two points.
bool enters(const std::vector<FlatPoint3>& polygon, const std::vector<FlatPoint3>& other);

// A loop without points in the middle of its sides.
std::vector<FlatPoint3> without_straight_points(const std::vector<FlatPoint3>& loop);

}  // namespace hottel

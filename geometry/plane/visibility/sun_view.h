// What is seen of a scene in the plane along one direction, from infinitely far.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/plane/arrangement/arrangement.h"

namespace hottel {

// What the rays of a sun meet first: strips side by side, each with the side of a piece that is met all over it.
//
//   (1) exact: which vertices bound a strip, and what is met there. Places across the rays are across(): the product
//       d x p of their direction and a place in integer form
//   (2) strips are ascending, and next to each other but for those in which nothing is met: they are left out, as is
//       what the rays run along
//   (3) reaches(p) iff the ray that ends in p meets no piece before it, or one of its two neighbours, infinitesimally
//       near, does not: borders of shadows are lit, and so is what the sun shines on
//
// REQUIRES a direction that is not zero, and that the arrangement outlives this.
// COST: a sweep, O(n log n) for n pieces; then some 10 ns for each halving of the strips.
class SunView2 {
 public:
  struct Strip {
    VertexId from, to;  // on its borders, across(from) < across(to)
    PieceSideId side;   // what is met
  };

  SunView2(const Arrangement2& arrangement, const Point2& direction);

  const std::vector<Strip>& strips() const { return strips_; }
  // The direction of the rays: coprime integers.
  const Point2& direction() const { return direction_; }

  // Of a place in integer form.
  Rational across(const Point2& place) const { return direction_.x * place.y - direction_.y * place.x; }
  Rational across(VertexId v) const { return across(arrangement_.vertices().exact(v)); }
  // How wide a strip is across the rays, times the length of direction(): in integer form.
  Rational width(const Strip& strip) const { return across(strip.to) - across(strip.from); }

  // REQUIRES an eye of the vertices of the arrangement.
  bool reaches(const Eye2& point) const;

 private:
  // A piece with its ends in the order of across(): the sun is on its left.
  struct Crossed {
    VertexId low, high;
    std::uint32_t piece;
  };
  struct IsNearer;

  int compare(VertexId v, VertexId w) const;
  int compare(VertexId v, const Eye2& point) const;
  bool is_behind(const Strip& strip, const Eye2& point) const;

  const Arrangement2& arrangement_;
  Point2 direction_;
  double x_, y_;                // of it, the larger of them 1
  std::vector<double> across_;  // of vertices, in doubles, in the unit of Vertices2::approximate()
  double error_ = 0;            // of each
  std::vector<Strip> strips_;
};

}  // namespace hottel

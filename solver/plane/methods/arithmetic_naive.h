// Orientations as most programs compute them.
#pragma once

#include <atomic>
#include <cmath>
#include <cstdint>
#include <vector>

#include "geometry/plane/arrangement/arrangement.h"

namespace hottel {

// Vertices in doubles as they stand in the scene, but for a power of two that keeps squares in range.
//
//   (1) coordinates are those of the scene, rounded to the nearest double; none is above 1 in size
//   (2) a sign may be wrong, and signs may contradict each other
class NaivePoints2 {
 public:
  explicit NaivePoints2(const Vertices2& vertices);

  // Sign of the determinant as it comes out: +1 when k lies left of i -> j, if rounding does not say otherwise.
  int orientation(VertexId i, VertexId j, VertexId k) const {
    const Place &p = place_[i.index()], &q = place_[j.index()], &r = place_[k.index()];
    const double determinant = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    return (determinant > 0) - (determinant < 0);
  }
  // In the unit of the scene times that power of two. Square root of the sum of squares, each operation rounded.
  double distance(VertexId i, VertexId j) const {
    const double dx = place_[j.index()].x - place_[i.index()].x, dy = place_[j.index()].y - place_[i.index()].y;
    return std::sqrt(dx * dx + dy * dy);
  }

 private:
  struct Place {
    double x, y;
  };
  std::vector<Place> place_;
};

// Points for the sweep about one vertex, which may go in circles where signs contradict each other.
//
//   (1) after `limit` steps every orientation is 0, and cut_off is one more: the sweep then turns about one vertex
//       after the other, each time until it meets a piece, and ends
template <class Points>
class StepLimit2 {
 public:
  StepLimit2(const Points& points, std::uint64_t limit, std::atomic<std::uint64_t>& cut_off)
      : points_(points), left_(limit), cut_off_(cut_off) {}

  int orientation(VertexId i, VertexId j, VertexId k) const {
    if (left_ == 0) return 0;
    if (--left_ == 0) ++cut_off_;
    return points_.orientation(i, j, k);
  }
  double distance(VertexId i, VertexId j) const { return points_.distance(i, j); }

 private:
  const Points& points_;
  mutable std::uint64_t left_;
  std::atomic<std::uint64_t>& cut_off_;
};

// More steps than a view takes by right signs, in any scene but one made for it: a view enters a triangle once for each
// window through which it is seen.
std::uint64_t naive_step_limit(const Triangulation2& triangulation);

// How many orientations the naive sweep asks for, and how many of them have another sign than the exact ones. A sweep
// that goes in circles is cut off as StepLimit2 does.
// COST: an exact orientation for each that is asked for, one vertex after the other.
struct WrongOrientations2 {
  std::uint64_t asked = 0, wrong = 0;
};
WrongOrientations2 count_wrong_orientations(const Arrangement2& arrangement, const NaivePoints2& points);

}  // namespace hottel

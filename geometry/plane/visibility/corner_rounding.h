// Corners of what a point sees as correctly rounded doubles.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/plane/arrangement/arrangement.h"
#include "geometry/plane/visibility/view_corners.h"
#include "kernel/int128.h"

namespace hottel {

// A point in scene coordinates: of each coordinate the nearest double, ties to even, as written_double has it: NaN
// where that is 0 and the coordinate is not.
struct RoundedPoint2 {
  double x, y;
  friend bool operator==(const RoundedPoint2&, const RoundedPoint2&) = default;
};

// How many points each way of rounding settled.
struct RoundingCounts2 {
  std::uint64_t known = 0;     // vertices and the eye: rounded once for all
  std::uint64_t filtered = 0;  // integers and one sum of doubles, with a proven bound
  std::uint64_t exact = 0;     // rationals
};

class EyeRounding2;

// What is kept of a scene to round corners.
//
//   (1) what EyeRounding2 rounds is written_double() of the exact coordinates, bit for bit
//   (2) while it lives any number of threads may use it
//
// REQUIRES that the arrangement outlives it. COST: some µs a vertex, on all threads.
class CornerRounding2 {
 public:
  explicit CornerRounding2(const Arrangement2& arrangement);

 private:
  friend class EyeRounding2;
  struct Place {
    std::int64_t x = 0, y = 0;  // integer form, where it is integers
    bool is_integer = false;
    DoubleDouble scene_x, scene_y;
  };
  Place place_of(VertexId v) const;
  Segment2 line_of(std::size_t piece) const;

  const Arrangement2& arrangement_;
  std::vector<Place> places_;    // by vertex
  std::vector<Segment2> lines_;  // by piece: two vertices of the line that carries it
  bool has_filter_ = false;      // 128 bits suffice, and no number comes near the ends of the range of doubles
  int unit_bits_ = 0;            // distances are divided into units of 2^-this, in integer form
  DoubleDouble unit_in_scene_;   // scale / 2^unit_bits_
  double error_ = 0;             // of a coordinate before it is rounded
};

// Rounds corners of what one eye sees.
class EyeRounding2 {
 public:
  // The eye in integer form, and the same point in scene coordinates. REQUIRES that all outlive this.
  EyeRounding2(const CornerRounding2& scene, const Point2& at, const Point2& point);

  // COST: about 40 ns for a corner behind a vertex; where the filter cannot decide (a tie, a zero, a number beyond its
  // limits) some µs.
  RoundedPoint2 operator()(const ViewCorner2& corner, RoundingCounts2& counts) const;

  // The exact corner, in scene coordinates. COST: some µs.
  Point2 exact(const ViewCorner2& corner) const;

 private:
  std::optional<RoundedPoint2> filtered(const ViewCorner2& corner) const;

  const CornerRounding2& scene_;
  const Point2& at_;
  const Point2& point_;
  std::int64_t x_ = 0, y_ = 0;    // the eye in integer form, times denominator_
  std::int64_t denominator_ = 0;  // 0: too large for the filter
};

}  // namespace hottel

// A part of a stretch along which what is seen is bounded by the same arcs. Internal to geometry/space/exchange.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/space/exchange/moving_planes.h"

namespace hottel {

// Where an arc of the boundary of what is seen begins or ends: a corner of a plane.
struct ArcEnd3 {
  PlaneId3 plane;
  std::uint64_t label;  // of the corner: equal for equal definitions
  int count;            // how often arcs on the plane end here, less how often they begin
  friend bool operator==(const ArcEnd3&, const ArcEnd3&) = default;
};

// A part of a stretch along which what is seen is bounded by the same arcs.
//
//   (1) Lambda, the integral of sign times direction over what is seen, is half the sum over arcs of their angle times
//       the unit normal of their plane: analytic in t
//   (2) no arcs: nothing is seen
//   (3) where all corners are close to each other Lambda is summed of differences of their directions: it loses digits
//       with its size, not with the square of it
struct StretchPiece3 {
  struct Arc {
    std::uint32_t plane, begin, end;  // in planes, corners
    double count;
    int turn = 0;  // of arcs of more than a right angle: the sign of the angle, which never passes half a turn
  };
  double low = 0, high = 0, base = 0;  // of t; base: where it was looked
  std::vector<ArcEnd3> signature;      // sorted
  std::vector<MovingVector3> planes, corners;
  std::vector<Arc> arcs;

  // Where a vector that Lambda is made of is nearly zero: at t = `at`, or close to at +- i `width`.
  struct NearZero {
    double at, width;
  };
  std::vector<NearZero> near_zeros;

  // Sets `turn` of all arcs; returns those of which doubles do not tell it.
  std::vector<std::uint32_t> find_turns();

  // True iff one of these is so close to the interval that rules of few points might not see what it does.
  bool is_steep(double from, double to) const;

  // Lambda at t = from + offset. `rounding`, where it is not null, is raised to what doubles may have lost, at most.
  Direction3 lambda(double from, double offset, double* rounding = nullptr) const;
};

}  // namespace hottel

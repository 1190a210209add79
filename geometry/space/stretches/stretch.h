// Stretches of lines along which view factors are integrated. Internal to geometry/space/exchange.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernel/determinant.h"

namespace hottel {

// A point in integer form (Vertices3), exactly: numerator / weight, weight > 0.
struct WeightedPoint3 {
  IntegerVector numerator;
  Integer weight = 1;
};

// The points (from + t way) / weight for 0 <= t <= 1, exactly; weight > 0.
struct Stretch3 {
  IntegerVector from, way;
  Integer weight = 1;
};

// From a to b.
Stretch3 stretch_between(const WeightedPoint3& a, const WeightedPoint3& b);

// Its part from t = low to t = high.
Stretch3 part_of(const Stretch3& s, const Rational& low, const Rational& high);

// A surface at a stretch: its closure contains it. Seen along the stretch, in directions w, the surface lies left
// where N . w > 0 with N its normal, or, where is_forward is false, the opposite of it.
struct StretchFace3 {
  std::uint32_t surface;
  bool is_forward;
};

// A stretch of the line of a surface, or of several, along which the surfaces at it are the same.
struct AtomicStretch3 {
  Stretch3 stretch;
  std::vector<StretchFace3> faces;  // ascending
};

// What a surface has of a line: the closed part from one point to another one.
struct LinePart3 {
  WeightedPoint3 from, to;
  StretchFace3 face;  // is_forward: as seen from `from` to `to`
  bool is_inside;     // the line runs through the inner points of the surface
};

// Returns the stretches into which parts of any number of lines cut each other: parts on one line are cut at each
// other's ends, and each stretch between neighbouring ends is there once, with all surfaces whose part contains it.
//
//   (1) exact: no two lines are taken for one, nor one for two
//   (2) keeps_inside: else stretches that run through the inside of a surface are left out, and those at which two
//       surfaces lie on opposite sides in one plane
//
// COST: n log n.
std::vector<AtomicStretch3> atomic_stretches(const std::vector<LinePart3>& parts, bool keeps_inside,
                                             std::span<const IntegerVector> normals);

}  // namespace hottel

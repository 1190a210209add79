// The exchange of two polygons with nothing between them, in 150 digits, to judge others by.
#pragma once

#include <boost/multiprecision/mpfr.hpp>
#include <vector>

namespace hottel {

using LongReal = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<150>>;

struct LongPoint {
  LongReal x, y, z;
};

// Returns S = A_i F_ij of two polygons that face each other, as a whole, with nothing between: 1 / (2 pi) times the
// integral of ln r dr . dr' around both.
//
//   (1) pairs of sides that are parallel, at right angles, or have a corner in common are closed forms; others, which
//       have to be apart, are integrated to more than 60 digits
//
// REQUIRES: no two sides that lie askew come nearer to each other than a tenth of their lengths.
// SEE: Sparrow, A new and simpler formulation for radiative angle factors, 1963; Howell's catalogue, C-11 to C-14, has
// the closed forms of rectangles.
LongReal contour_measure(const std::vector<LongPoint>& first, const std::vector<LongPoint>& second);

}  // namespace hottel

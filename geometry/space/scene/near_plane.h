// Polygons that are plane but for the digits in which they were written.
#pragma once

#include <optional>
#include <string_view>

#include "geometry/space/scene/polygon.h"

namespace hottel {

// The finest decimal digit of numbers that are read one after another.
class FinestDigit3 {
 public:
  // A number as parse_rational reads it. A fraction has no last digit; that of "1.50" is a hundredth, of "2e3" a
  // thousand.
  void take(std::string_view number);
  // What the finest stands for; 0 where there is none.
  Rational unit() const;

 private:
  std::optional<long> exponent_;
};

// The spacing of binary floating-point numbers with this many digits (24 of floats, 53 of doubles) at the largest
// coordinate of a polygon.
Rational float_spacing(const Polygon3& polygon, int digits);

// Sets is_nearly_plane, and returns it: true iff the points do not lie in one plane, and lie off that of their largest
// triangle (bend_of) by at most 2^-40 of their diameter, or by at most 4 units and 1e-4 of their diameter; and can be
// cut into triangles. `unit` is what the last digit of the coordinates stands for, 0 where they have none.
//
// COST: linear for a polygon that is plane; else that of bend_of and triangles_of_loops.
bool accept_nearly_plane(Polygon3& polygon, const Rational& unit);

}  // namespace hottel

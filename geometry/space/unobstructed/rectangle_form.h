// The direct exchange area of two rectangles in closed form.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/space/point.h"
#include "kernel/rational.h"

namespace hottel {

// A finite sum of arc tangents and logarithms, over pi:
//
//   (1/pi) (sum of c sqrt(r) atan(p / sqrt(r)) + sum of c log(q)),   all numbers rational, r > 0, p > 0, q > 1
//
// Terms of one r and p are one, and so are those of one q; none has the coefficient 0. Logarithms are of whole numbers,
// of small primes by themselves: log(9/4) is 2 log(3) - 2 log(2).
class ArcSum3 {
 public:
  void add_arc(const Rational& coefficient, const Rational& square, const Rational& numerator);  // c sqrt(r) atan(...)
  void add_log(const Rational& coefficient, const Rational& of);                                 // REQUIRES of > 0

  bool is_zero() const { return arcs_.empty() && logs_.empty(); }
  // (4*sqrt(5)*atan(2/sqrt(5)) - 1/2*log(3))/pi
  std::string to_string() const;
  // The number, to some 1e-16 of the largest term.
  double value() const;

  friend bool operator==(const ArcSum3&, const ArcSum3&) = default;

 private:
  std::map<std::pair<Rational, Rational>, Rational> arcs_;  // coefficients, by square and numerator
  std::map<Rational, Rational> logs_;
};

// Returns S of two rectangles in closed form, with nothing between them, in squares of the unit of coordinates; nothing
// where they are not two rectangles of rational sides that lie parallel or at right angles, with sides along each
// other.
//
//   (1) they see each other with their fronts, where counter-clockwise; what of one is behind the other counts for
//       nothing
//   (2) exact
//
// REQUIRES the corners of plane polygons in order. SEE: Howell, Catalog of Radiation Heat Transfer Configuration
// Factors, C-13 (parallel) and C-15 (at right angles).
std::optional<ArcSum3> rectangle_exchange(const std::vector<Point3>& from, const std::vector<Point3>& to);

// Returns the area of such a rectangle; nothing of other polygons.
std::optional<Rational> rectangle_area(const std::vector<Point3>& corners);

}  // namespace hottel

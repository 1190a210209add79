// The beam of a light in the plane: which share of its power leaves between two directions.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/light.h"
#include "geometry/plane/scene/scene.h"
#include "kernel/ball.h"
#include "kernel/enclosure.h"
#include "kernel/plain_functions.h"

namespace hottel {

// The beam of a light: the directions at most Light::half_angle() away from its axis, its borders among them. The axis
// is a rational direction turned by a rational number of degrees.
//
//   (1) which side of a border a rational direction lies on is decided exactly: the tangent of a rational number of
//       degrees is rational only at multiples of 45 (Niven), where integers decide; elsewhere balls of growing
//       precision do, which end
//   (2) the real shares of steps that lead once around sum to 1
//   (3) a beam of 180 degrees has no border
//
// Directions are vectors of any length, not zero.
class Beam2 {
 public:
  // The light as it stands (LightPlace2::turned).
  Beam2(const Light& light, const LightPlace2& place);

  // The share of the power that leaves in the directions from `from` counter-clockwise to `to`, which differ: within
  // bounds that differ by less than 2^-50 of it; from 0 to less than 2^-960 where it is below that; {0, 0} iff no
  // direction between them is inside the beam.
  // COST: some 10 µs for a whole falloff up to 64, some 50 to 500 µs for any other, however large.
  Enclosure share(const Point2& from, const Point2& to) const;

  // What of the directions from `from` counter-clockwise to `to`, less than half a turn on, is in the beam, exactly:
  // nothing but a border, a part, all. kNothing iff share() is {0, 0}.
  enum class Meets : unsigned char { kNothing, kPart, kAll };
  Meets meets(const Point2& from, const Point2& to) const;

  // True iff a direction is in the beam, borders included. COST: some 100 ns but next to a border.
  bool contains(const Point2& direction) const;
  // The intensity in a direction over the power [1/radian], in doubles: I0 cos^n t / P; 0 outside the beam, exactly.
  // The direction: its coordinates, each rounded correctly, and `exact`, which returns them as Point2 and is asked
  // where a border or, with a falloff, a right angle to the axis is near, and where doubles do not tell the direction.
  // COST: about 60 ns but next to a border; some 10 µs within a quarter of a degree of a right angle.
  template <class Exact>
  double intensity(double x, double y, const Exact& exact) const {
    if (is_round_) return peak_;
    const double size = std::max(std::fabs(x), std::fabs(y));
    if (!(size > kLeastSize && size < 1 / kLeastSize)) return intensity(exact());
    const double t = angle_in_doubles(x, y), beyond = std::fabs(t) - half_in_radians_;
    if (std::fabs(beyond) > kAngleError ? beyond > 0 : !contains(exact())) return 0;
    if (falloff_in_doubles_ == 0) return peak_;
    if (is_near_right_angle(t)) return uncut_intensity(exact());
    return peak_ * same_bits::pow(same_bits::cos(t), falloff_in_doubles_);
  }
  double intensity(const Point2& direction) const { return contains(direction) ? uncut_intensity(direction) : 0; }
  // The same whether or not the direction is in the beam; but where n > 0, 0 beyond 90 degrees. COST: some µs.
  double uncut_intensity(const Point2& direction) const;

 private:
  // A place of a direction relative to the axis: below the beam, in it, above it.
  enum class Side : signed char { kBelow = -1, kInside = 0, kAbove = 1 };

  // From the axis, in [-pi, pi]; of a direction between kLeastSize and its reciprocal off by less than kAngleError,
  // which is some 90 times what rounding makes of it.
  double angle_in_doubles(double x, double y) const;
  static constexpr double kAngleError = 1e-13, kLeastSize = 1e-290;  // of a direction in doubles, and its reciprocal
  // Where the cosine of an angle that is off by some ulps of a right angle may be off by 2^-45 of itself.
  static bool is_near_right_angle(double t) { return std::fabs(std::fabs(t) - std::numbers::pi / 2) < 0x1p-8; }
  Ball cosine(const Point2& direction, long precision) const;
  bool is_far_below_doubles(const Point2& from, const Point2& to, Side first, Side last, bool is_behind) const;

  Ball raw_angle(const Point2& direction, long precision) const;
  Ball angle(const Point2& direction, long precision) const;
  int compare(const Point2& direction, const Rational& degrees) const;
  int turns_to_add(const Point2& direction) const;
  Side side(const Point2& direction) const;
  bool passes_behind(const Point2& from, const Point2& to) const;
  bool is_dark(const Point2& from, const Point2& to, Side first, Side last, bool is_behind) const;
  bool touches_only(const Point2& from, const Point2& to, Side first, Side last, bool is_behind) const;
  Ball power_up_to(const Point2& direction, Side side, long precision) const;
  Ball border_power(long precision) const;

  Point2 direction_;  // of coprime integers
  Rational turned_, half_angle_, falloff_;
  double x_ = 1, y_ = 0;  // of the direction, the larger of them 1
  double falloff_in_doubles_ = 0, turned_in_radians_ = 0, half_in_radians_ = 0, peak_ = 0;
  bool is_round_;
};

}  // namespace hottel

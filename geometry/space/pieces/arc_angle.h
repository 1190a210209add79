// Angles of arcs in doubles, as plain arithmetic. Internal to geometry/space.
#pragma once

#include <cmath>

namespace hottel {

namespace detail {

// The arc tangent of z less z, |z| <= 0.66: z^3 P(z^2) / Q(z^2), off by some 2^-54 of the arc tangent.
// SEE: Moshier, Methods and Programs for Mathematical Functions, 1989 (Cephes, atan.c).
inline double arc_tangent_less_argument(double z) {
  const double s = z * z;
  const double p =
      (((-8.750608600031904122785e-1 * s - 1.615753718733365076637e1) * s - 7.500855792314704667340e1) * s -
       1.228866684490136173410e2) *
          s -
      6.485021904942025371773e1;
  const double q =
      ((((s + 2.485846490142306297962e1) * s + 1.650270098316988542046e2) * s + 4.328810604912902668951e2) * s +
       4.853903996359136964868e2) *
          s +
      1.945506571482613964425e2;
  return z * (s * (p / q));
}

}  // namespace detail

// The angle from -pi to pi of which sine and cosine are times some positive number; 0 where both are 0.
//
//   (1) within 2^-51 of the angle
//   (2) of the opposite sine it is the opposite
//   (3) the same bits on every processor, and in lanes
//
// REQUIRES: both are finite, and of a size whose quotient doubles tell.
inline double angle_of(double sine, double cosine) {
  constexpr double kQuarter = 0x1.921fb54442d18p-1, kRest = 0x1.1a62633145c07p-55;  // pi / 4
  const double y = std::fabs(sine), x = std::fabs(cosine);
  const bool is_steep = y > x;
  const double more = is_steep ? y : x, less = is_steep ? x : y;
  // Near pi / 4 the angle from there.
  const bool is_middle = less > 0.5 * more;
  const double over = is_middle ? less - more : less, under = is_middle ? less + more : more;
  const double z = under > 0 ? over / under : 0;
  // So many quarters of pi, and from there to one side or the other.
  const double in_first = is_middle ? 1 : 0, in_half = is_steep ? 2 - in_first : in_first;
  const bool is_behind = cosine < 0;
  const double quarters = is_behind ? 4 - in_half : in_half, side = is_steep != is_behind ? -1 : 1;
  const double rest = quarters * kRest + side * (z + detail::arc_tangent_less_argument(z));
  return std::copysign(quarters * kQuarter + rest, sine);
}

// The same of an arc of which the sign of the angle may be known, +1 or -1, as more than half a turn is none; 0 where
// it is not. Where the cosine is negative the sine may have been lost, sign and all.
inline double arc_angle(double sine, double cosine, int turn) {
  constexpr double kFull = 0x1.921fb54442d18p+2;  // 2 pi
  const double angle = angle_of(sine, cosine), turned = turn * angle;
  const double known = turn * (turned < 0 ? turned + kFull : turned);
  return cosine < 0 && turn != 0 ? known : angle;
}

}  // namespace hottel

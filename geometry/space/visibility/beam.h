// Round beams of light, and what of their power goes into cones of directions.
#pragma once

#include <string>

#include "geometry/space/point.h"
#include "geometry/space/visibility/direction.h"
#include "geometry/space/visibility/exact_visibility_map.h"
#include "kernel/ball.h"
#include "kernel/enclosure.h"
#include "kernel/rational.h"

namespace hottel {

// How a point sends out light: the intensity is I0 cos^n t at the angle t <= f from the axis, and 0 beyond.
//
//   (1) n > 0: f is cut to 90 degrees
//   (2) what goes out in all is P: I0 = P (n + 1) / (2 pi (1 - cos^(n+1) f))
//
// The default sends out the same in all directions.
struct Beam3 {
  Vector3 axis{0, 0, 1};      // of any length
  Rational half_angle = 180;  // f, in degrees
  Rational falloff = 0;       // n

  // f as it is cut.
  Rational reach() const { return falloff > 0 && half_angle > 90 ? Rational(90) : half_angle; }
  // Whether it is the same in all directions.
  bool is_even() const { return falloff == 0 && half_angle == 180; }
  friend bool operator==(const Beam3&, const Beam3&) = default;
};

// Returns what is wrong with a beam, as the end of a sentence ("the falloff is negative"); empty when nothing is: the
// axis is not zero, 0 < f <= 180, n >= 0.
std::string beam_problem(const Beam3& beam);

// A beam, ready to be asked what it sends where.
//
//   (1) side(w) is +1, 0, -1 for directions within the open beam, on its border, beyond: exactly. Of a beam to all
//       directions, +1
//   (2) share(cone) is a ball around the part of P that goes into the cone, at most 2^-digits of it wide where 4096
//       bits are enough for that, as they are for shares down to 10^-500; with a falloff it may be from 0 to 2^-960
//       where the part is less than that; exactly 0, the number, where the open beam and the cone have no common inner
//       direction
//   (3) meets(cone) is exact, and kNothing iff the share is 0
//   (4) shares of cones that are turned or mirrored together with the axis are those of the cones before
//   (5) intensity(w) is I / P in doubles, for directions of any length: off by a few ulps, and some n ulps more where n
//       is large; 0 where w is beyond the border, and at a right angle to the axis with a falloff. Both are decided
//       exactly. [unit: 1 / steradian]
//   (6) uncut_intensity(w) is the same number wherever w is, though nothing leaves there; but 0 where n > 0 and w is
//       not within 90 degrees
//
// The border of the beam never needs a tolerance: the cosine squared of whole and broken degrees is rational for
// multiples of 30 and 45 only (Niven), so what balls do not tell apart is compared as rationals.
//
// For several threads at once.
// COST: share: some ten microseconds a corner and half a microsecond more for each whole n up to 1000; for other n up
// to some milliseconds for each that is in the beam, however large n is.
// SEE: docs/design/space/lights.md; geometry/space/visibility/beam_arc.h.
class BeamPower3 {
 public:
  // REQUIRES a beam without a problem.
  explicit BeamPower3(const Beam3& beam);

  // What of a cone is in the beam: nothing but its border, a part, all of it with the border.
  enum class Meets : unsigned char { kNothing, kPart, kAll };

  const Beam3& beam() const { return beam_; }
  int side(const IntegerVector& direction) const;
  Ball share(const ExactCone3& cone, long digits = 60) const;
  Meets meets(const ExactCone3& cone) const;
  double intensity(const IntegerVector& direction) const;
  double uncut_intensity(const IntegerVector& direction) const;

 private:
  // Of a beam of at most 90 degrees.
  struct Narrow {
    IntegerVector axis;
    Rational half_angle, falloff;
    Direction3 middle = {};  // the axis in doubles
    double cosine = 0;       // of the half angle
    Ball sine_squared = {};  // the same exactly, in 128 bits

    int side(const IntegerVector& direction) const;
  };
  bool is_far_below_doubles(const ExactCone3& cone) const;
  static Meets meeting(const Narrow& beam, const ExactCone3& cone);
  static Ball share_at(const Narrow& beam, const ExactCone3& cone, Meets meets, long precision);

  Beam3 beam_;
  bool is_wide_;  // beyond 90 degrees: then narrow_ is what is left out, around the opposite axis
  Narrow narrow_;
  Direction3 axis_;
  double axial_ = 0;  // intensity along the axis
  double exponent_ = 0;
};

}  // namespace hottel

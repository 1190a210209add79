// What a round beam sends through regions of directions, as integrals along the arcs that bound them, in balls.
#pragma once

#include <memory>

#include "kernel/ball.h"
#include "kernel/determinant.h"

namespace hottel {

// An arc of a great circle on the sphere of directions, less than a half turn: from `from` to `to`, counter-clockwise
// around `normal`. Vectors of any length.
// REQUIRES: normal is orthogonal to both ends, and a positive multiple of from x to.
struct DirectionArc3 {
  const IntegerVector& normal;
  const IntegerVector& from;
  const IntegerVector& to;
};

// A beam whose intensity is cos^n t at the angle t <= f from its axis, and none beyond, where f <= 90 degrees: its
// integrals at one precision.
//
// With k = n + 1 and c = cos t the part of its power that leaves within t is g(t) = (1 - c^k) / (1 - cos^k f), and what
// goes into a region is 1/2 pi times the integral of g dphi along its boundary, phi the angle around the axis (Stokes).
// Along the great circle of normal m, at the angle u from its point nearest to the axis a,
//
//     c = c0 cos u,   dphi = s du / (1 - c^2),   s = a . m,   c0^2 + s^2 = 1
//
//   (1) within(arc) is the integral of g dphi, for arcs whose points have t <= f. The region holds no direction that is
//       opposite to the axis
//   (2) entering(arc) is the integral of (g - 1) dphi over what of the arc has t < f. The share of a region is the sum
//       of these over 2 pi, and 1 more where the axis is within it; of the angle at the axis over 2 pi where it is on
//       the boundary. An arc whose great circle goes through the axis adds nothing
//   (3) the balls contain the real numbers, and become narrow with the precision
//
// COST: some ten microseconds an arc and half a microsecond more for each whole n up to 1000; else a quadrature with
// proven bounds: up to some milliseconds. SEE: Arvo, Applications of irradiance tensors to the simulation of
// non-Lambertian phenomena, 1995, for whole n; Johansson, Numerical integration in arbitrary-precision ball arithmetic,
// 2018.
class BeamArcs3 {
 public:
  // REQUIRES: the axis is not zero, 0 < half_angle <= 90, falloff >= 0.
  BeamArcs3(const IntegerVector& axis, const Rational& half_angle, const Rational& falloff, long precision);
  BeamArcs3(BeamArcs3&&) noexcept;
  ~BeamArcs3();

  Ball within(const DirectionArc3& arc) const;
  Ball entering(const DirectionArc3& arc) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// Returns the angle between two vectors, from 0 to pi. REQUIRES that neither is zero.
Ball angle_between_3(const IntegerVector& a, const IntegerVector& b, long precision);

}  // namespace hottel

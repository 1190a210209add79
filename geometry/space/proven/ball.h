// Real numbers of which it is known how far they may be off. Internal to geometry/space.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/space/vectors/local_vector.h"
#include "kernel/plain_functions.h"

namespace hottel {

namespace ball_arithmetic_3 {

// Radii are sums and products of a few doubles that are not negative: they are rounded far less than this, and what
// underflows in a centre is less than the second.
constexpr double kUp = 1 + 0x1p-45, kTiny = 0x1p-900;
constexpr double kNothingKnown = std::numeric_limits<double>::infinity();
constexpr double kUnit = 0x1p-53;
// What arc tangents and logarithms of the library may be off, in units: it promises less than two.
constexpr double kOfLibrary = 8;

inline double up(double radius) { return radius * kUp + kTiny; }
inline double down(double length) { return length * (1 - 0x1p-45); }
inline double size_of(double a) { return std::fabs(a); }
template <class Real>
double size_of(const Real& a) {
  return std::fabs(static_cast<double>(a)) * kUp + kTiny;
}

}  // namespace ball_arithmetic_3

// A real number, no further from `mid` than `rad`. Every operation gives a ball with all that it could be of numbers in
// the balls it is of. What is known of nothing has an infinite radius, or one that is no number.
//
//   (1) Real is double, long double or WideReal
template <class Real>
struct Ball3 {
  Real mid = 0;
  double rad = 0;

  static Ball3 of(const Real& value, double error) { return {value, error}; }
};

template <class Real>
Ball3<Real> operator+(const Ball3<Real>& a, const Ball3<Real>& b) {
  using namespace ball_arithmetic_3;
  const Real mid = a.mid + b.mid;
  return {mid, up(a.rad + b.rad + kRoundoff<Real> * size_of(mid))};
}
template <class Real>
Ball3<Real> operator-(const Ball3<Real>& a) {
  return {-a.mid, a.rad};
}
template <class Real>
Ball3<Real> operator-(const Ball3<Real>& a, const Ball3<Real>& b) {
  return a + -b;
}
template <class Real>
Ball3<Real> operator*(const Ball3<Real>& a, const Ball3<Real>& b) {
  using namespace ball_arithmetic_3;
  const double p = size_of(a.mid), q = size_of(b.mid);
  return {a.mid * b.mid, up(p * b.rad + q * a.rad + a.rad * b.rad + kRoundoff<Real> * (p * q))};
}
template <class Real>
Ball3<Real> inverse(const Ball3<Real>& a) {
  using namespace ball_arithmetic_3;
  const double least = down(down(size_of(a.mid))), inner = down(least - a.rad);
  if (!(inner > kTiny)) return {Real(0), kNothingKnown};
  return {Real(1 / a.mid), up(a.rad / (least * inner) + 2 * kRoundoff<Real> / least)};
}
// |sqrt(w) - sqrt(c)| = |w - c| / (sqrt(w) + sqrt(c)).
template <class Real>
Ball3<Real> root(const Ball3<Real>& a) {
  using namespace ball_arithmetic_3;
  using std::sqrt;
  const double least = down(down(static_cast<double>(a.mid)));
  if (!(least > a.rad && least > kTiny)) return {Real(0), kNothingKnown};
  const Real mid = sqrt(a.mid);
  return {mid, up(a.rad / down(std::sqrt(least)) + 2 * kRoundoff<Real> * size_of(mid))};
}
// Its slope is 1 at most.
template <class Real>
Ball3<Real> arc_tangent(const Ball3<Real>& a) {
  using namespace ball_arithmetic_3;
  using same_bits::atan;
  const Real mid = atan(a.mid);
  return {mid, up(a.rad + kOfLibrary * kRoundoff<Real> * size_of(mid))};
}

}  // namespace hottel

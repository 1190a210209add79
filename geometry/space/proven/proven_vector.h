// Vectors that depend on how far a point has moved, with all that they may be off. Internal to geometry/space.
#pragma once

#include <array>

#include "geometry/space/proven/ball.h"
#include "geometry/space/vectors/moving_vector.h"
#include "geometry/space/vectors/wide_vector.h"

namespace hottel {

// power[0] + s power[1] + s^2 power[2], s = t - base. Each component of a power is within its error of the number.
template <class Real>
struct ProvenVector3 {
  std::array<LocalVector3<Real>, 3> power;
  std::array<double, 3> error{};
  double base = 0;
  bool is_linear = true;
};

// What a moving vector of MovingPlanes3 encloses, times a power of two so that it is about 1 long.
ProvenVector3<double> proven_vector_3(const MovingVector3& vector);
// The same of one of which each power is right to two units of the last place.
template <class Real>
ProvenVector3<Real> proven_vector_3(const WideVector3<Real>& vector);
// In doubles.
inline const ProvenVector3<double>& in_doubles_3(const ProvenVector3<double>& vector) { return vector; }
template <class Real>
ProvenVector3<double> in_doubles_3(const ProvenVector3<Real>& vector);

// A vector of balls.
template <class Number>
struct ProvenPoint3 {
  Number x, y, z;
};

template <class Number>
Number dot(const ProvenPoint3<Number>& a, const ProvenPoint3<Number>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Number>
ProvenPoint3<Number> cross(const ProvenPoint3<Number>& a, const ProvenPoint3<Number>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// A vector at t = base + s.
template <class Number, class Real>
ProvenPoint3<Number> at(const ProvenVector3<Real>& v, const Number& s) {
  const auto component = [&](Real LocalVector3<Real>::*axis) {
    const Number first = Number::of(v.power[0].*axis, v.error[0]), second = Number::of(v.power[1].*axis, v.error[1]);
    if (v.is_linear) return first + s * second;
    return first + s * (second + s * Number::of(v.power[2].*axis, v.error[2]));
  };
  return {component(&LocalVector3<Real>::x), component(&LocalVector3<Real>::y), component(&LocalVector3<Real>::z)};
}

}  // namespace hottel

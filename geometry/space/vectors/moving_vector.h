// Vectors that depend on how far a point has moved, in doubles. Internal to geometry/space/exchange.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/space/visibility/direction.h"
#include "kernel/determinant.h"

namespace hottel {

// A vector that depends on how far the point has moved, s = t - base: first + s second + s^2 third, in doubles; `first`
// with its bound, and `terms` are the sizes of what the three were made of.
struct MovingVector3 {
  BoundedVector first;
  Direction3 second, third;
  std::array<double, 3> terms{};
  double base = 0;

  // At t = from + offset: near the base no digits of a small offset are lost.
  Direction3 at(double from, double offset) const {
    const double s = (from - base) + offset;
    return {first.x + s * (second.x + s * third.x), first.y + s * (second.y + s * third.y),
            first.z + s * (second.z + s * third.z)};
  }
};

// Where the vector is shortest, about, for s from low to high; a vector that is linear in s also beyond them.
double nearest_to_zero(const MovingVector3& vector, double low, double high);

// The vector at base + s.
Direction3 value_at(const MovingVector3& vector, double s);

// Where the vector is shortest between low and high, about; a simple zero at an end is left out.
double shortest_between(const MovingVector3& vector, double low, double high);

MovingVector3 opposite(const MovingVector3& vector);

inline Direction3 plain(const BoundedVector& a) { return {a.x, a.y, a.z}; }
inline double size_of(const Direction3& a) { return std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)}); }

// value * 2^exponent, for exponents of any size.
double ldexp_3(double value, long exponent);

// t = mantissa * 2^-places, for t from 0 to 1.
void split_double_3(double t, Integer& mantissa, unsigned& places);

}  // namespace hottel

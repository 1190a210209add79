// Points of space and the ways between them.
#pragma once

#include <array>

#include "kernel/rational.h"

namespace hottel {

// A point with exact coordinates, of the scene as it was typed. Two points are equal iff their coordinates are, as
// numbers.
//
// REQUIRES: coordinates in lowest terms, as all arithmetic on rationals leaves them.
struct Point3 {
  Rational x, y, z;
  friend bool operator==(const Point3&, const Point3&) = default;
};

// The way from one point to another, exact.
struct Vector3 {
  Rational x, y, z;
  bool is_zero() const { return x == 0 && y == 0 && z == 0; }
  friend bool operator==(const Vector3&, const Vector3&) = default;
};

// Returns the doubles nearest to the coordinates.
inline std::array<double, 3> to_doubles(const Point3& p) { return {to_double(p.x), to_double(p.y), to_double(p.z)}; }
inline std::array<double, 3> to_doubles(const Vector3& v) { return {to_double(v.x), to_double(v.y), to_double(v.z)}; }

// The way from b to a.
inline Vector3 operator-(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

inline Rational dot(const Vector3& a, const Vector3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
// The square of the length.
inline Rational square(const Vector3& a) { return dot(a, a); }

// The vector product: zero iff a and b are parallel or one of them is zero.
inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace hottel

// Directions in doubles, and what a cone of them measures.
#pragma once

#include <cmath>
#include <span>

namespace hottel {

struct Vector3;

// A direction: a unit vector, up to rounding.
struct Direction3 {
  double x = 0, y = 0, z = 0;
  friend bool operator==(const Direction3&, const Direction3&) = default;
};

// Sums, multiples and products of directions as vectors: what they give may have any length.
inline Direction3 operator+(const Direction3& a, const Direction3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Direction3 operator-(const Direction3& a, const Direction3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Direction3 operator-(const Direction3& a) { return {-a.x, -a.y, -a.z}; }
inline Direction3 operator*(double s, const Direction3& a) { return {s * a.x, s * a.y, s * a.z}; }
inline double dot(const Direction3& a, const Direction3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Direction3 cross(const Direction3& a, const Direction3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(const Direction3& a) { return std::sqrt(dot(a, a)); }
inline Direction3 unit(const Direction3& a) { return (1 / length(a)) * a; }

// Returns the unit vector along an exact one, whatever its length. REQUIRES that it is not zero.
Direction3 unit_of_3(const Vector3& v);

// Whether two corners of a cone are nearly opposite: then they alone do not tell it.
bool has_opposite_corners_3(std::span<const Direction3> corners);

// Returns the solid angle of a convex cone less than a half space, as a fraction of the full sphere. Its corners are in
// order, as the determinant of any three of them is not negative; no two are nearly opposite.
//
//   (1) off by some 1e-16 a corner when the corners are right to the last digit
//
// SEE: Van Oosterom, Strackee, The solid angle of a plane triangle, 1983.
double solid_angle_fraction_3(std::span<const Direction3> corners);

// The same of any convex cone less than a half space, from the unit normals of the planes that bound it, inward and in
// order.
//
//   (1) off by some 1e-16 a plane, absolutely, when the normals are right to the last digit
//
// SEE: Girard, Invention nouvelle en l'algebre, 1629.
double solid_angle_fraction_by_normals_3(std::span<const Direction3> inward);

// Returns the view factor of a cone as solid_angle_fraction_3 takes it from a point with a unit normal: the integral of
// the cosine over it, over pi.
//
//   (1) off by some 1e-16 a corner
//   (2) negative where directions are below the horizon
//
// SEE: Lambert, Photometria, 1760.
double view_factor_3(std::span<const Direction3> corners, const Direction3& normal);

// The same of any convex cone less than a half space. The plane of inward[k] goes through corner k and the next one.
double view_factor_by_normals_3(std::span<const Direction3> corners, std::span<const Direction3> inward,
                                const Direction3& normal);

}  // namespace hottel

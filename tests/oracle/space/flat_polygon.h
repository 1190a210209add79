// Points and polygons of space in doubles, for oracles that need no exact answer.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "tests/oracle/space/space_polygon.h"

namespace hottel::oracle {

struct Vector {
  double x = 0, y = 0, z = 0;
};

inline Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vector operator*(double s, const Vector& a) { return {s * a.x, s * a.y, s * a.z}; }
inline double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline double length(const Vector& a) { return std::sqrt(dot(a, a)); }
inline Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// Plane and convex, counter-clockwise seen from its front.
using FlatPolygon = std::vector<Vector>;

inline FlatPolygon to_doubles(const SpacePolygon& polygon) {
  FlatPolygon result;
  for (const SpacePoint& p : polygon) result.push_back({p.x.get_d(), p.y.get_d(), p.z.get_d()});
  return result;
}

// The normal on the front whose length is twice the area.
inline Vector doubled_area(const FlatPolygon& polygon) {
  Vector sum;
  for (std::size_t k = 2; k < polygon.size(); ++k)
    sum = sum + cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
  return sum;
}
inline double area(const FlatPolygon& polygon) { return length(doubled_area(polygon)) / 2; }

// A plane: normal . p = offset; heights above it are lengths.
struct FlatPlane {
  Vector normal;
  double offset = 0;

  explicit FlatPlane(const FlatPolygon& polygon) : normal(doubled_area(polygon)) {
    normal = (1 / length(normal)) * normal;
    for (const Vector& p : polygon) offset += dot(normal, p) / static_cast<double>(polygon.size());
  }
  double height(const Vector& p) const { return dot(normal, p) - offset; }
};

// Two polygons and what stands between them, opaque on both sides.
struct FlatPair {
  FlatPolygon i, j;
  std::vector<FlatPolygon> between;

  FlatPair reversed() const { return {j, i, between}; }
};

// Polygons 0 and 1 of a scene and all others.
inline FlatPair first_pair(const std::vector<SpacePolygon>& polygons) {
  FlatPair pair{to_doubles(polygons[0]), to_doubles(polygons[1]), {}};
  for (std::size_t k = 2; k < polygons.size(); ++k) pair.between.push_back(to_doubles(polygons[k]));
  return pair;
}

}  // namespace hottel::oracle

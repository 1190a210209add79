// Points and polygons of space as the oracles take them, and exact products of vectors.
#pragma once

#include <gmpxx.h>

#include <vector>

namespace hottel::oracle {

struct SpacePoint {
  mpq_class x, y, z;
  friend bool operator==(const SpacePoint&, const SpacePoint&) = default;
};

inline SpacePoint operator-(const SpacePoint& a, const SpacePoint& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline mpq_class dot(const SpacePoint& a, const SpacePoint& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline SpacePoint cross(const SpacePoint& a, const SpacePoint& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// Plane and convex, counter-clockwise seen from its front; its first three points are not on one line.
using SpacePolygon = std::vector<SpacePoint>;

inline SpacePoint normal_of(const SpacePolygon& p) { return cross(p[1] - p[0], p[2] - p[0]); }

}  // namespace hottel::oracle

// The vertices of a scene in integer form.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/space/point.h"
#include "kernel/determinant.h"
#include "kernel/support/id.h"

namespace hottel {

using VertexId3 = Id<struct VertexTag3>;

// Points of a scene, translated by the first one and scaled to coprime integers.
//
//   (1) integer forms are the same, whatever the translation and the scale of the scene
//   (2) scene coordinate = origin + scale * integer form, exactly; scale > 0
//
// Where every coordinate in integer form is below 2^60 it is also held in 64 bits (is_small).
class Vertices3 {
 public:
  Vertices3() = default;
  explicit Vertices3(const std::vector<Point3>& points);

  std::size_t size() const { return exact_.size(); }
  const IntegerVector& exact(VertexId3 v) const { return exact_[v.index()]; }

  struct Small {
    std::int64_t x, y, z;
  };
  bool is_small() const { return small_.size() == exact_.size(); }
  const Small& small(VertexId3 v) const { return small_[v.index()]; }

  // The integer form times 2^-shift(), one shift for all.
  const BoundedVector& approximate(VertexId3 v) const { return approximate_[v.index()]; }
  // The same of to - from. COST: a few ns.
  BoundedVector approximate_difference(VertexId3 from, VertexId3 to) const {
    const BoundedVector &a = approximate_[from.index()], &b = approximate_[to.index()];
    BoundedVector d{b.x - a.x, b.y - a.y, b.z - a.z};
    d.size = std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
    if (a.error != 0 || b.error != 0 || d.size > 0x1p53) d.error = 1.001 * (a.error + b.error + 0x1p-53 * d.size);
    return d;
  }
  long shift() const { return shift_; }

  const Rational& scale() const { return scale_; }
  const Point3& origin() const { return origin_; }
  Point3 from_scene(const Point3& point) const;

 private:
  std::vector<IntegerVector> exact_;
  std::vector<Small> small_;
  std::vector<BoundedVector> approximate_;
  long shift_ = 0;
  Rational scale_ = 1;
  Point3 origin_;
};

// The cross product of the edges from a to b and from b to c.
inline IntegerVector turn_at(const Vertices3& vertices, VertexId3 a, VertexId3 b, VertexId3 c) {
  return cross(difference(vertices.exact(b), vertices.exact(a)), difference(vertices.exact(c), vertices.exact(b)));
}

}  // namespace hottel

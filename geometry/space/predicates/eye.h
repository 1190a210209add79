// A point to look from, and the vertices as it sees them.
#pragma once

#include <memory>
#include <vector>

#include "geometry/space/predicates/sun_frame.h"
#include "geometry/space/predicates/vertices.h"

namespace hottel {

// The vectors from a point to all vertices; or from a sun, which is infinitely far: those of SunFrame3, each times a
// positive number that doubles and integers do not share.
//
//   (1) exactly: integers, denominator() times the difference in integer form
//   (2) in doubles: those integers times 2^-shift(), one shift for all, each off by at most 2^-52 of its size
//
// Not for several threads at once: what is exact is made when it is asked for, and kept.
// COST: three products of 128 bits a vertex where those suffice, else of big integers.
class Eye3 {
 public:
  // The point is given in scene coordinates. REQUIRES: the vertices outlive the eye.
  Eye3(const Vertices3& vertices, const Point3& point);
  // A sun, by the direction of its rays, which is not zero.
  static Eye3 of_sun(const Vertices3& vertices, const Vector3& direction);

  // Of a sun; else null.
  const SunFrame3* sun() const { return sun_.get(); }

  const BoundedVector& toward(VertexId3 v) const { return toward_[v.index()]; }
  const IntegerVector& exact_toward(VertexId3 v);
  // True iff the eye is the vertex.
  bool coincides_with(VertexId3 v) const { return toward_[v.index()].size == 0 && coincides_exactly(v); }

  // The scene's unit, so that scene vector = unit() * doubles of toward(). Of no meaning for a sun.
  double unit() const { return unit_; }
  // The same for exact_toward().
  Rational exact_unit() const { return vertices_->scale() / denominator_; }

 private:
  explicit Eye3(const Vertices3& vertices) : vertices_(&vertices), exact_(vertices.size()) {}
  IntegerVector exact_vector(VertexId3 v) const;
  bool coincides_exactly(VertexId3 v) const { return is_zero(exact_vector(v)); }
  void look_small();
  void look_large();

  const Vertices3* vertices_;
  IntegerVector numerator_;  // the point in integer form = numerator / denominator
  Integer denominator_ = 1;
  std::vector<BoundedVector> toward_;
  std::vector<std::unique_ptr<IntegerVector>> exact_;
  double unit_ = 1;
  long shift_ = 0;
  std::shared_ptr<const SunFrame3> sun_;
};

}  // namespace hottel

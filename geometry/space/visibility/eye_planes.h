// Planes through an eye, and the signs of directions beside them. Internal to geometry/space/visibility.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/space/arrangement/occluders.h"
#include "geometry/space/predicates/eye.h"
#include "geometry/space/visibility/eye_plane.h"

namespace hottel {

// The end of an edge of a fragment. `direction` is a positive multiple of the direction to it in doubles; what it is
// exactly is said by a vertex (the direction to it, or the opposite) or by the cross product of two plane normals.
struct ConeCorner3 {
  BoundedVector direction;
  PlaneSide3 plane;          // of the edge that begins here
  VertexId3 vertex;          // or none
  bool is_antipode;          // the direction is opposite to the vertex
  PlaneSide3 first, second;  // where there is no vertex
};

// The plane of a polygon, as a sun asks for it.
inline SunFrame3::Plane plane_of(const Occluders3& occluders, std::size_t s) {
  return {occluders.exact_normal(s), occluders.vertices().exact(occluders.outline(s).front())};
}

// Signs of directions beside planes through an eye, and of polygons beside it.
//
//   (1) every sign is exact
//   (2) counts() says which tier settled them; with always_exact, sign() always asks integers
//
// For one thread: exact normals are made when they are asked for, and kept. The edges of the scene have the planes
// 0 .. edge_count() - 1; others are added.
class EyePlanes3 {
 public:
  // The eye is given in scene coordinates. REQUIRES that the occluders outlive this.
  EyePlanes3(const Occluders3& occluders, const Point3& eye, bool always_exact)
      : EyePlanes3(occluders, Eye3(occluders.vertices(), eye), always_exact) {}
  // An eye or a sun of the vertices of the occluders.
  EyePlanes3(const Occluders3& occluders, Eye3 eye, bool always_exact);

  const Occluders3& occluders() const { return occluders_; }
  Eye3& eye() { return eye_; }
  const Eye3& eye() const { return eye_; }

  // Which side of a polygon the eye sees: +1 its front, -1 its back, 0 neither: the eye is in its plane.
  int facing(std::size_t s) const { return facing_[s]; }

  // Where a vertex lies of the plane of a polygon: +1 on the side of the eye, -1 beyond, 0 on it.
  // REQUIRES facing(s) != 0.
  int nearness(VertexId3 v, std::size_t s) {
    SignTier tier;
    const int sign = occluders_.side_of(v, s, tier);
    counts_.count(tier);
    return sign * facing_[s];
  }

  // Adds the plane that tells in which directions polygon s is nearer than polygon t.
  // REQUIRES: facing() of both is not 0, and their planes are not one.
  PlaneSide3 add_crossing(std::size_t s, std::size_t t);
  PlaneSide3 add_horizon(const IntegerVector& normal);

  // The sign of m . w for the direction w to a vertex, or to a corner.
  int sign(VertexId3 v, PlaneSide3 side) {
    const int result = filtered(eye_.toward(v), side.plane);
    return turned(result == kUndecided ? settled_sign(v, side.plane) : result, side);
  }
  int sign(const ConeCorner3& corner, PlaneSide3 side) {
    const int result = filtered(corner.direction, side.plane);
    return turned(result == kUndecided ? settled_sign(corner, side.plane) : result, side);
  }

  // The corner where the edge on plane `first` ends and that on `second` begins.
  // REQUIRES that the planes differ; the direction is m of first x m of second.
  ConeCorner3 corner(PlaneSide3 first, PlaneSide3 second);
  ConeCorner3 corner_at(VertexId3 v, PlaneSide3 plane) const { return {eye_.toward(v), plane, v, false, {}, {}}; }
  // The direction of a corner: coprime integers.
  IntegerVector exact_direction(const ConeCorner3& corner);

  const std::vector<PlaneDefinition3>& definitions() const { return definitions_; }
  // A positive multiple of m.
  const BoundedVector& normal(PlaneId3 plane) const { return normals_[plane.index()]; }
  const IntegerVector& exact_normal(PlaneId3 plane);
  const SignCounts& counts() const { return counts_; }

 private:
  void find_facing();
  PlaneSide3 add(const PlaneDefinition3& definition, IntegerVector normal);
  VertexId3 shared_vertex(PlaneId3 a, PlaneId3 b) const;
  bool passes_through(PlaneId3 plane, VertexId3 v) const;
  int filtered(const BoundedVector& w, PlaneId3 plane) {
    const int result = always_exact_ ? kUndecided : filtered_sign(w, normals_[plane.index()]);
    if (result != kUndecided) counts_.count(SignTier::kFilter);
    return result;
  }
  static int turned(int sign, PlaneSide3 side) { return side.is_opposite ? -sign : sign; }
  // What the filter leaves open.
  int settled_sign(VertexId3 v, PlaneId3 plane);
  int settled_sign(const ConeCorner3& corner, PlaneId3 plane);
  IntegerVector exact_cross(PlaneSide3 first, PlaneSide3 second);

  const Occluders3& occluders_;
  Eye3 eye_;
  bool always_exact_;
  std::vector<signed char> facing_;
  std::vector<BoundedVector> normals_;
  std::vector<std::unique_ptr<IntegerVector>> exact_normals_;
  std::vector<PlaneDefinition3> definitions_;
  SignCounts counts_;
};

}  // namespace hottel

// A scene of space as it is seen along one direction, from infinitely far.
#pragma once

#include <array>
#include <cstddef>

#include "geometry/space/predicates/vertices.h"
#include "kernel/ball.h"

namespace hottel {

// The projection of a scene along the rays of a sun, as vectors that stand for directions.
//
// A projective map takes the sun to the origin and the scene to before it, z > 0: its rays become rays from the origin,
// and planes stay planes. The vector to a point is (u, v, c) up to a positive factor, where (u, v) is where its ray
// meets a plane across, and c > 0 the same for all. So all that is told of what an eye sees by signs of determinants is
// told of what a sun sees, with these vectors instead of those from the eye.
//
//   (1) toward() is exact, integers; of two points it is in the same direction iff they are on one ray
//   (2) seen from the origin the image is not mirrored: what is counter-clockwise seen against the rays is so there
//   (3) approximate() is toward() times the factor by which the projective map brings near what is far along the rays:
//       between 1/2 and 1 times 1/c, the farther the larger; each number is off by at most 2^-48 of the largest one
//
// REQUIRES a direction that is not zero, and that the vertices outlive this. COST: linear in the vertices.
class SunFrame3 {
 public:
  SunFrame3(const Vertices3& vertices, const Vector3& direction);

  // The direction of its rays: coprime integers.
  const IntegerVector& direction() const { return direction_; }

  // To a point in integer form, times a weight > 0; and to one in scene coordinates: coprime integers.
  IntegerVector toward(const IntegerVector& place, const Integer& weight) const;
  IntegerVector toward(const Point3& point) const;
  BoundedVector approximate(VertexId3 v) const;

  // How a polygon with this normal is turned: +1 its front meets the rays, -1 its back, 0: they run along it.
  int facing(const IntegerVector& normal) const;

  // The normal of the plane through the sun on whose positive side polygon s is met before polygon t: each by its
  // normal and a vertex, in integer form. REQUIRES that neither runs along the rays.
  struct Plane {
    const IntegerVector &normal, &anchor;
  };
  IntegerVector crossing(const Plane& s, const Plane& t) const;

  // Where the ray of a vector meets a plane, in scene coordinates. REQUIRES a plane that does not run along the rays.
  Point3 meeting(const IntegerVector& vector, const Plane& plane) const;

  // The area across the rays of the triangle between the rays of three vectors, which are counter-clockwise.
  // [scene unit squared]
  Ball area(const IntegerVector& a, const IntegerVector& b, const IntegerVector& c, long precision) const;

 private:
  static Integer part(const IntegerVector& v, std::size_t axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }
  Integer first(const IntegerVector& place) const;
  Integer second(const IntegerVector& place) const;

  const Vertices3& vertices_;
  IntegerVector direction_;
  std::size_t i_, j_, k_;      // axes in cyclic order; along the last one the direction is steepest
  int sign_;                   // of its component there
  Integer steep_;              // that component
  Integer u_, v_;              // subtracted from first() and second()
  Integer depth_, reach_, c_;  // the least depth, how far the scene reaches in it, and c
};

}  // namespace hottel

// Exact points of a side of a piece, as a camera sees them.
#pragma once

#include "geometry/face.h"
#include "geometry/space/point.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/visibility/direction.h"

namespace hottel {

// The plane of a side of a piece, seen from an eye that is not in it.
class SidePlane3 {
 public:
  // REQUIRES that prepared outlives it.
  SidePlane3(const PreparedScene3& prepared, const Face& side, const Point3& eye);

  // The way from the eye to where a direction meets the plane.
  Direction3 way(const Direction3& direction) const;
  // The point of the plane at the end of a way, within some 2^-30 of the size of the piece: it is in the plane exactly.
  Point3 point(const Direction3& way) const;
  // The unit normal, to the side.
  const Direction3& normal() const { return normal_; }

 private:
  Point3 origin_;
  Vector3 a_, b_;               // the plane is origin + s a + t b
  Direction3 to_origin_;        // from the eye
  Direction3 dual_a_, dual_b_;  // s and t of a way from the origin
  Direction3 normal_;
};

}  // namespace hottel

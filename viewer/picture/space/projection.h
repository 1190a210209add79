// How a camera maps directions to its picture.
#pragma once

#include <vector>

#include "geometry/space/scene/scene.h"
#include "geometry/space/visibility/direction.h"
#include "viewer/picture/space/pixel_values.h"

namespace hottel {

// The way from one point to another, each of its coordinates rounded once.
Direction3 rounded_way(const Point3& from, const Point3& to);

// A number for each place of a picture: x * p.x + y * p.y + one.
struct AffineValue3 {
  double x = 0, y = 0, one = 0;
  double at(const Pixel& p) const { return x * p.x + y * p.y + one; }
};

// The picture of a camera, in pixels.
class Projection3 {
 public:
  // REQUIRES a camera without a problem (camera_problem).
  explicit Projection3(const Camera3& camera);

  // The picture of a convex cone, as far as it is in the picture; nothing where none is.
  PixelPolygon picture(std::vector<Direction3> corners) const;

  // dot(d, m) of the direction d that is seen at a place, which is 1 long along the axis of the camera.
  AffineValue3 dot_with(const Direction3& m) const;

 private:
  double width_, height_, half_width_ = 1, half_height_ = 1;
  Direction3 forward_, right_, up_;
};

}  // namespace hottel

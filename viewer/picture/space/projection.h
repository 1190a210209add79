// How a camera maps directions to its picture.
#pragma once

#include <array>
#include <optional>
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

  // The picture of the straight line between the ends of two ways, as far as it is in the picture.
  std::optional<std::array<Pixel, 2>> line(Direction3 from, Direction3 to) const;

  // The direction that is seen at a place, 1 long along the axis of the camera.
  Direction3 direction(const Pixel& place) const;

  // A direction as the camera has it: to the right, upwards, and away from the eye.
  Direction3 turned(const Direction3& way) const { return {dot(way, right_), dot(way, up_), dot(way, forward_)}; }

  // dot(d, m) of the direction d that is seen at a place, which is 1 long along the axis of the camera.
  AffineValue3 dot_with(const Direction3& m) const;

 private:
  std::array<Direction3, 5> inside() const;
  // REQUIRES a direction before the eye.
  Pixel place(const Direction3& way, double out) const;

  double width_, height_, half_width_ = 1, half_height_ = 1;
  Direction3 forward_, right_, up_;
};

}  // namespace hottel

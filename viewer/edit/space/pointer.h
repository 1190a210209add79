// Where a hand points in a picture of space.
#pragma once

#include <cmath>
#include <optional>

#include "geometry/space/scene/scene.h"
#include "geometry/space/visibility/direction.h"
#include "viewer/picture/canvas.h"

namespace hottel {

// The place, in doubles.
inline Direction3 place_of(const Point3& p) { return {to_double(p.x), to_double(p.y), to_double(p.z)}; }

// A hand in a picture: the eye, the picture at distance 1 from it, and the place of the mouse in that.
struct Pointer3 {
  Direction3 eye{0, 0, 0};                                   // a place
  Direction3 forward{0, 1, 0}, right{1, 0, 0}, up{0, 0, 1};  // 1 long, at right angles
  Pixel at{};                                                // the mouse sees along forward + at.x right + at.y up
  double pixel = 1e-3;                                       // how long a pixel is in that picture
  double reach = 9, arm = 60;          // how near counts as touching, how far handles are from a light [pixels]
  bool along_axis = false;             // a place moves along x, y or z
  bool alone = false;                  // what is dragged parts from what coincides with it
  bool is_whole = false;               // a polygon stands for its group
  std::optional<Direction3> aim = {};  // what lies there, where an axis is to point at it

  // How far in front of the eye a place is.
  double depth(const Direction3& place) const { return dot(place - eye, forward); }
  // Where it is seen in the picture at distance 1. REQUIRES depth(place) > 0.
  Pixel seen(const Direction3& place) const {
    const Direction3 way = place - eye;
    return {dot(way, right) / dot(way, forward), dot(way, up) / dot(way, forward)};
  }
  // The way along which a place of that picture is seen: 1 long along `forward`.
  Direction3 way_to(const Pixel& place) const { return forward + place.x * right + place.y * up; }
  // How long a pixel is at a place. REQUIRES depth(place) > 0.
  double length_of_pixel(const Direction3& place) const { return pixel * depth(place); }
};

}  // namespace hottel

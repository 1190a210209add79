// Where a hand puts things in space: places in doubles, and the exact places near them.
#pragma once

#include <optional>
#include <vector>

#include "geometry/space/point.h"
#include "viewer/edit/space/pointer.h"

namespace hottel {

// Returns how many decimals places have where that one is: the last is finer than a pixel there (decimals_at). REQUIRES
// pointer.depth(place) > 0.
int decimals_at_place(const Direction3& place, const Pointer3& pointer);

// A place in decimals, but for coordinates that are nearly those of another one: these stay, with all their digits.
Point3 rounded_place(const Direction3& place, const Point3& other, int decimals);

// Where the mouse has brought a place, parallel to the picture. REQUIRES pointer.depth(from) > 0.
Direction3 place_beside(const Direction3& from, const Pointer3& pointer);

// How far the mouse has moved a place along x, y or z: along that which is seen to go most the same way.
Direction3 way_along_seen_axis(const Direction3& from, const Pointer3& pointer);

// Returns which of x, y and z (0, 1, 2) that is; nothing where none is seen to go that way.
std::optional<int> axis_seen_along(const Direction3& from, const Pointer3& pointer);

// Whether a hand may bring a thing there: not where a coordinate is no number, or a million times as far as it is from
// the eye.
bool is_within_reach_of_hands(const Direction3& from, const Direction3& to, const Pointer3& pointer);

// A plane of space: all points p with dot(normal, p) = offset. The normal is not zero.
struct Plane3 {
  Vector3 normal;
  Rational offset;
};
Plane3 plane_through(const Point3& point, const Vector3& normal);

// Where a point may go: everywhere, or in a plane, along a line, nowhere else, exactly. It is always where it began.
//
//   (1) at(), rounded() and onto() return points of all planes that were taken
//   (2) a plane through the point where it began is always taken; another where it meets what is there, and is not
//       parallel to it, and then the point has to leave where it began
class Freedom3 {
 public:
  explicit Freedom3(Point3 begin) : begin_(std::move(begin)) {}

  // The point stays in the plane through it with that normal. REQUIRES a normal that is not zero.
  void hold(const Vector3& normal) { take(plane_through(begin_, normal)); }
  // It stays on the axis of x, y or z (0, 1, 2).
  void hold_on_axis(int axis);
  // Takes a plane; false where it is parallel to what is there.
  bool take(const Plane3& plane);

  // In how many independent ways it may go: 3 to 0.
  int dimensions() const { return 3 - static_cast<int>(planes_.size()); }

  // Where the mouse has brought it, in doubles: parallel to the picture; the place of the plane or the line that is
  // under the mouse, or nearest to that.
  Direction3 at(const Pointer3& pointer) const;
  // The place that has short decimals: in a plane two coordinates, along a line one, those that are farthest from being
  // told by the others. The rest follows exactly.
  Point3 rounded(const Direction3& place, int decimals) const;
  // The place nearest to a point, exactly.
  Point3 onto(const Point3& point) const;

 private:
  Vector3 line() const { return cross(planes_[0].normal, planes_[1].normal); }
  Point3 solved(const Plane3& third) const;

  Point3 begin_;
  std::vector<Plane3> planes_;  // independent of each other
};

}  // namespace hottel

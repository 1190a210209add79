// From where a window looks at a scene in space.
#pragma once

#include <optional>
#include <utility>

#include "geometry/space/scene/scene.h"
#include "geometry/space/visibility/direction.h"
#include "viewer/edit/space/pointer.h"
#include "viewer/picture/canvas.h"
#include "viewer/window/window.h"

namespace hottel {

// An eye, what it looks at, and what is up: moved by hands. In doubles; the scene sees it as exact numbers, rounded to
// a fraction of the scene's size that no eye sees.
//
//   (1) whatever is done to it, camera() has no problem (camera_problem): the eye never looks straight up or down, and
//       never comes nearer to what it looks at than a millionth of the scene's size, nor farther than a thousand sizes
//   (2) orbit() keeps the distance, pan() and walk() the direction, zoom() the direction and the target, turn() the eye
//       and the distance
//   (3) a frame shows all that the camera it was made of shows: one that is narrower shows more above and below
//   (4) orbit() and turn() by an angle and back lead back, but for rounding, unless (1) stopped them
// Angles are in degrees, lengths those of the scene.
class EyeCamera3 {
 public:
  EyeCamera3() = default;
  // Looks as that camera does. REQUIRES a camera without a problem. size: of the scene, its longest side; above 0.
  EyeCamera3(const Camera3& camera, double size);

  // Goes around what is looked at: to the right and up, as the eye sees it.
  void orbit(double right, double up);
  // Looks farther to the right and up.
  void turn(double right, double up);
  // Moves across what is seen.
  void pan(double right, double up);
  // Goes nearer: divides the distance.
  void zoom(double factor);
  // Goes nearer to a place, as if all around it grew: divides its distance and that of what is looked at, and the place
  // stays where it is seen. REQUIRES a place apart from the eye.
  void zoom_to(const Direction3& place, double factor);
  // Goes on the ground, as far as it looks along that, and up.
  void walk(double forward, double right, double up);

  double distance() const { return length(target_ - eye_); }
  double size() const { return size_; }
  // How long a pixel is, where what is looked at is; as far away as a place is, along the way that is looked.
  double length_of_pixel(FrameSize frame) const;
  double length_of_pixel_at(const Direction3& place, FrameSize frame) const;

  Camera3 camera(FrameSize frame) const;
  // Where a place is seen; nothing where it is not in front of the eye.
  std::optional<Pixel> at(const Direction3& place, FrameSize frame) const;
  // The two ends of what is seen of a straight line, as far as it is in front of the eye; nothing where none of it is.
  std::optional<std::pair<Pixel, Pixel>> line(const Direction3& from, const Direction3& to, FrameSize frame) const;

  // A hand with the mouse there.
  Pointer3 pointer(const Pixel& mouse, FrameSize frame) const;

  friend bool operator==(const EyeCamera3&, const EyeCamera3&) = default;

 private:
  // The way that is looked, 1 long, and what is right of it.
  Direction3 forward() const { return unit(target_ - eye_); }
  Direction3 right() const { return unit(cross(forward(), up_)); }
  Direction3 turned(double right_degrees, double up_degrees) const;
  // Half the height of a frame over the distance; the angle of that, in degrees.
  double half_height(FrameSize frame) const;
  Rational field_of_view(FrameSize frame) const;

  Direction3 eye_{0, 0, 0}, target_{0, 1, 0}, up_{0, 0, 1};  // places, and a way 1 long
  Rational field_of_view_ = 40;
  double aspect_ = 4.0 / 3;  // width over height of the camera it was made of
  double size_ = 1;
};

}  // namespace hottel

// Which part of a plane a window shows.
#pragma once

#include <array>

#include "geometry/plane/scene/scene.h"
#include "viewer/picture/plane/frame.h"
#include "viewer/window/window.h"

namespace hottel {

// A place in the middle of the window, and a scale. In doubles: for the eye and the mouse.
//
//   (1) at(place_of(pixel)) is the pixel, but for rounding, in frame() of the same size
//   (2) zoom() leaves the place under the pixel where it is
//   (3) the scale stays within a factor of 10^4 of that of fit(), so that a frame always has an extent
class Camera2 {
 public:
  // Shows the whole scene, its grid included, with that many pixels free at each side; a scene that is a point, or
  // empty, with an extent of 1.
  void fit(const Scene2& scene, FrameSize size, double left_right, double top, double bottom);

  // Moves what is seen by that many pixels.
  void pan(double dx, double dy);
  void zoom(Pixel fixed, FrameSize size, double factor);

  double pixels_per_length() const { return scale_; }
  std::array<double, 2> place_of(Pixel pixel, FrameSize size) const;
  Pixel at(const std::array<double, 2>& place, FrameSize size) const;
  Frame2 frame(FrameSize size) const;

  friend bool operator==(const Camera2&, const Camera2&) = default;

 private:
  std::array<double, 2> middle_{0, 0};
  double scale_ = 100, fitted_ = 100;  // pixels a length of 1 takes; by fit()
};

}  // namespace hottel

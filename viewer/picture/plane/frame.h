// How a scene is fitted into a picture.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/plane/scene/scene.h"
#include "kernel/rounded_share.h"
#include "viewer/picture/canvas.h"

namespace hottel {

// The size of a sheet and the room kept free around the drawing, in pixels.
struct SheetMargins2 {
  double left = 0, right = 0, top = 0, bottom = 0;
};

// Places in the scene as places in the picture: y up, one scale for both axes, the drawing as large as the margins
// allow, and the picture as high as the drawing asks for.
//
//   (1) points of the scene and the extra points lie within the margins
//   (2) the height is at most 3 widths and at most kMaxPictureSide; where that binds the drawing is centred
//   (3) coordinates of any size and digits: differences are formed before rounding
//   (4) a flat scene has room all the same: an eighth of the width, or nearly
// Throws ContractViolation where what is required does not hold.
class Frame2 {
 public:
  // REQUIRES width > left + right, finite extra points.
  Frame2(const Scene2& scene, const std::vector<std::array<double, 2>>& extra_points, double width,
         const SheetMargins2& margins);

  // Exactly the region from min to max, filling a picture of that size, stretched to it.
  // REQUIRES min < max, positive sizes.
  Frame2(const Point2& min, const Point2& max, double width, double height) : Frame2(min, max, width, height, {}) {}
  // The same inside the margins. REQUIRES that they leave room.
  Frame2(const Point2& min, const Point2& max, double width, double height, const SheetMargins2& margins);

  double width() const { return width_; }
  double height() const { return height_; }
  Pixel top_left() const { return top_left_; }  // of the region inside the margins
  Pixel bottom_right() const { return bottom_right_; }
  double pixels_per_length() const { return pixels_per_extent_x_ / extent_double_; }

  // Where a point of the scene lies in the picture, y down; points beside the region lie beside the picture.
  Pixel at(const Point2& point) const;
  // The same for a point in doubles, whose place is found in doubles.
  Pixel at(const std::array<double, 2>& point) const;
  // What lies in a place of the picture, in scene coordinates, in doubles; beyond their range infinite or NaN.
  std::array<double, 2> place(const Pixel& pixel) const;

 private:
  // extent: the longer side, 1 for a scene that is a single point.
  void set_region(const Point2& min, const Rational& extent);

  RoundedShare share_x_, share_y_;  // of the extent
  double min_x_double_, min_y_double_, extent_double_;
  double width_, height_;
  double pixels_per_extent_x_, pixels_per_extent_y_;
  Pixel origin_;  // where (min_x, min_y) lies
  Pixel top_left_, bottom_right_;
};

}  // namespace hottel

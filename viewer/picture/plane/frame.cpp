#include "viewer/picture/plane/frame.h"

#include <algorithm>
#include <cmath>

#include "geometry/plane/scene/bounding_box.h"
#include "kernel/exact_double.h"
#include "kernel/support/failure.h"
#include "viewer/picture/cairo_canvas.h"

namespace hottel {
namespace {

constexpr double kHighest = 3;  // times the width
constexpr double kLowest = 0.12;

}  // namespace

Frame2::Frame2(const Scene2& scene, const std::vector<std::array<double, 2>>& extra_points, double width,
               const SheetMargins2& margins)
    : width_(width) {
  HOTTEL_REQUIRE(width > margins.left + margins.right);
  Box2 box = bounding_box(scene);
  for (std::size_t k = 0; k < extra_points.size(); ++k) {
    const auto& [x, y] = extra_points[k];
    HOTTEL_REQUIRE(std::isfinite(x) && std::isfinite(y));
    const Point2 point{exact_value(x), exact_value(y)};
    if (k == 0 && scene.edges.empty()) box = Box2::of(point);
    box.include(point);
  }
  const Rational wide = box.width(), high = box.height();
  Rational extent = std::max(wide, high);
  if (extent == 0) extent = 1;
  set_region(box.min, extent);

  const double share_x = to_double(wide / extent), share_y = to_double(high / extent);
  const double room_x = width - margins.left - margins.right;
  const double most_y = std::min(kHighest * width, double{kMaxPictureSide}) - margins.top - margins.bottom;
  HOTTEL_REQUIRE(most_y > 0);
  pixels_per_extent_x_ = std::min(share_x > 0 ? room_x / share_x : most_y, share_y > 0 ? most_y / share_y : room_x);
  pixels_per_extent_y_ = pixels_per_extent_x_;
  const double drawn_x = share_x * pixels_per_extent_x_, drawn_y = share_y * pixels_per_extent_y_;
  height_ = std::ceil(margins.top + std::clamp(drawn_y, std::min(most_y, kLowest * width), most_y) + margins.bottom);
  height_ = std::min(height_, double{kMaxPictureSide});
  top_left_ = {margins.left, margins.top};
  bottom_right_ = {width - margins.right, height_ - margins.bottom};
  origin_ = {top_left_.x + (room_x - drawn_x) / 2, bottom_right_.y - (bottom_right_.y - top_left_.y - drawn_y) / 2};
}

Frame2::Frame2(const Point2& min, const Point2& max, double width, double height, const SheetMargins2& margins)
    : width_(width), height_(height) {
  const double wide = width - margins.left - margins.right, high = height - margins.top - margins.bottom;
  HOTTEL_REQUIRE(min.x < max.x && min.y < max.y && wide > 0 && high > 0);
  const Rational extent = std::max<Rational>(max.x - min.x, max.y - min.y);
  set_region(min, extent);
  pixels_per_extent_x_ = wide / to_double((max.x - min.x) / extent);
  pixels_per_extent_y_ = high / to_double((max.y - min.y) / extent);
  top_left_ = {margins.left, margins.top};
  bottom_right_ = {width - margins.right, height - margins.bottom};
  origin_ = {top_left_.x, bottom_right_.y};
}

void Frame2::set_region(const Point2& min, const Rational& extent) {
  share_x_ = RoundedShare(min.x, extent);
  share_y_ = RoundedShare(min.y, extent);
  min_x_double_ = to_double(min.x);
  min_y_double_ = to_double(min.y);
  extent_double_ = to_double(extent);
}

Pixel Frame2::at(const Point2& point) const {
  return {origin_.x + pixels_per_extent_x_ * share_x_.of(point.x),
          origin_.y - pixels_per_extent_y_ * share_y_.of(point.y)};
}

Pixel Frame2::at(const std::array<double, 2>& point) const {
  return {origin_.x + pixels_per_extent_x_ * ((point[0] - min_x_double_) / extent_double_),
          origin_.y - pixels_per_extent_y_ * ((point[1] - min_y_double_) / extent_double_)};
}

std::array<double, 2> Frame2::place(const Pixel& pixel) const {
  return {min_x_double_ + (pixel.x - origin_.x) / pixels_per_extent_x_ * extent_double_,
          min_y_double_ + (origin_.y - pixel.y) / pixels_per_extent_y_ * extent_double_};
}

}  // namespace hottel

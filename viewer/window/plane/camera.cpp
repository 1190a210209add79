#include "viewer/window/plane/camera.h"

#include <algorithm>

#include "geometry/plane/scene/bounding_box.h"
#include "kernel/exact_double.h"

namespace hottel {
namespace {

constexpr double kMostZoom = 1e4;

}  // namespace

void Camera2::fit(const Scene2& scene, FrameSize size, double left_right, double top, double bottom) {
  Box2 box{{0, 0}, {1, 1}};
  if (!scene.edges.empty()) box = bounding_box(scene);
  if (scene.edges.empty() && !scene.grids.empty()) box = Box2::of(scene.grids.front().min);
  for (const Grid2& grid : scene.grids) {
    box.include(grid.min);
    box.include(grid.max);
  }
  const std::array<double, 2> low = to_doubles(box.min), high = to_doubles(box.max);
  const double extent = std::max(high[0] - low[0], high[1] - low[1]);
  const double wide = extent > 0 ? std::max(high[0] - low[0], 1e-3 * extent) : 1;
  const double tall = extent > 0 ? std::max(high[1] - low[1], 1e-3 * extent) : 1;
  const double room_x = std::max(1.0, size.width - 2 * left_right), room_y = std::max(1.0, size.height - top - bottom);
  scale_ = fitted_ = std::min(room_x / wide, room_y / tall);
  middle_ = {(low[0] + high[0]) / 2, (low[1] + high[1]) / 2 + (top - bottom) / 2 / scale_};
}

void Camera2::pan(double dx, double dy) {
  middle_[0] -= dx / scale_;
  middle_[1] += dy / scale_;
}

void Camera2::zoom(Pixel fixed, FrameSize size, double factor) {
  const std::array<double, 2> before = place_of(fixed, size);
  scale_ = std::clamp(scale_ * factor, fitted_ / kMostZoom, fitted_ * kMostZoom);
  const std::array<double, 2> after = place_of(fixed, size);
  for (std::size_t k = 0; k < 2; ++k) middle_[k] += before[k] - after[k];
}

std::array<double, 2> Camera2::place_of(Pixel pixel, FrameSize size) const {
  return {middle_[0] + (pixel.x - size.width / 2.0) / scale_, middle_[1] - (pixel.y - size.height / 2.0) / scale_};
}

Pixel Camera2::at(const std::array<double, 2>& place, FrameSize size) const {
  return {size.width / 2.0 + (place[0] - middle_[0]) * scale_, size.height / 2.0 - (place[1] - middle_[1]) * scale_};
}

Frame2 Camera2::frame(FrameSize size) const {
  const double half_x = size.width / 2.0 / scale_, half_y = size.height / 2.0 / scale_;
  const Point2 min{exact_value(middle_[0]) - exact_value(half_x), exact_value(middle_[1]) - exact_value(half_y)};
  const Point2 max{exact_value(middle_[0]) + exact_value(half_x), exact_value(middle_[1]) + exact_value(half_y)};
  return {min, max, static_cast<double>(size.width), static_cast<double>(size.height)};
}

}  // namespace hottel

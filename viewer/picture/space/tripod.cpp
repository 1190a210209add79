#include "viewer/picture/space/tripod.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "viewer/picture/palette.h"
#include "viewer/picture/space/projection.h"

namespace hottel {
namespace {

constexpr double kRoom = 64, kLength = 21, kLetters = 14, kPen = 1.4, kHead = 5, kLabel = 7, kAside = 9;  // units
constexpr double kEndOn = 0.15;  // of its length: what is left of an axis that is seen end on

using Coordinate = Rational Point3::*;

std::string reach_of(const Scene3& scene, Coordinate at, const char* name, const std::string& length_unit) {
  if (scene.polygons.empty()) return "";
  Rational low = scene.polygons[0].points[0].*at, high = low;
  for (const Polygon3& polygon : scene.polygons)
    for (const Point3& point : polygon.points) {
      low = std::min(low, point.*at);
      high = std::max(high, point.*at);
    }
  return fmt::format("{} {:.6g} to {:.6g} {}", name, to_double(low), to_double(high), length_unit);
}

}  // namespace

Tripod3::Tripod3(const Scene3& scene, const Camera3& camera, const std::string& length_unit) {
  const Projection3 projection(camera);
  const std::array<std::pair<const char*, Coordinate>, 3> all{
      {{"x", &Point3::x}, {"y", &Point3::y}, {"z", &Point3::z}}};
  const std::array<Direction3, 3> ways{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (std::size_t k = 0; k < 3; ++k) {
    const Direction3 turned = projection.turned(ways[k]);
    axes_[k] = {turned.x, turned.y, turned.z, all[k].first, reach_of(scene, all[k].second, all[k].first, length_unit)};
  }
}

double Tripod3::width(const PictureCanvas& canvas, double unit) const {
  double wide = 0;
  for (const Axis& axis : axes_) wide = std::max(wide, canvas.text_width(axis.reach, {.size = kLetters * unit}));
  return kRoom * unit + wide;
}

void Tripod3::draw(PictureCanvas& canvas, Pixel top_left, double unit) const {
  // The arrows together in the middle of their room.
  double left = 0, right = 0, low = 0, high = 0;
  for (const Axis& axis : axes_) {
    left = std::min(left, axis.right);
    right = std::max(right, axis.right);
    low = std::min(low, axis.up);
    high = std::max(high, axis.up);
  }
  const double half = kRoom / 2 - 4;
  const Pixel centre{top_left.x + (half - kLength * (left + right) / 2) * unit,
                     top_left.y + (half + kLength * (low + high) / 2) * unit};
  std::array<const Axis*, 3> order{&axes_[0], &axes_[1], &axes_[2]};
  std::ranges::stable_sort(order, [](const Axis* a, const Axis* b) { return a->away > b->away; });
  for (const Axis* axis : order) draw_axis(canvas, *axis, centre, unit);
  for (std::size_t k = 0; k < 3; ++k)
    canvas.text(Mark::kAxis, {top_left.x + kRoom * unit, top_left.y + (14 + 19 * static_cast<double>(k)) * unit},
                axes_[k].reach, {.size = kLetters * unit, .colour = palette::kSoftInk});
}

// How far a label gives way, in units, to that of a longer arrow.
double Tripod3::aside_of(const Axis& axis) const {
  const auto label = [](const Axis& a) {
    const double share = std::hypot(a.right, a.up), far = kLength + kLabel / std::max(share, kEndOn);
    return std::array{a.right * far, a.up * far};
  };
  for (const Axis& other : axes_) {
    if (std::hypot(other.right, other.up) <= std::hypot(axis.right, axis.up)) continue;
    const auto [x, y] = label(axis);
    const auto [other_x, other_y] = label(other);
    if (std::hypot(x - other_x, y - other_y) < kLetters) return x < other_x ? -kAside : kAside;
  }
  return 0;
}

void Tripod3::draw_axis(PictureCanvas& canvas, const Axis& axis, Pixel centre, double unit) const {
  const double share = std::hypot(axis.right, axis.up);
  const TextStyle style{.size = kLetters * unit, .colour = palette::kInk, .anchor = TextAnchor::kCentre};
  if (share < kEndOn) {
    canvas.disc(Mark::kAxis, centre, 2.5 * unit, palette::kInk);
    canvas.text(Mark::kAxis, {centre.x - 8 * unit, centre.y + 13 * unit}, axis.name, style);
    return;
  }
  const double x = axis.right / share, y = -axis.up / share;
  const auto at = [&](double way, double aside) {
    return Pixel{centre.x + (way * x - aside * y) * unit, centre.y + (way * y + aside * x) * unit};
  };
  const double tip = kLength * share, base = std::max(0.0, tip - kHead);
  canvas.stroke(Mark::kAxis, centre, at(base, 0), palette::kInk, kPen * unit);
  const Pixel head[] = {at(tip, 0), at(base, 0.4 * kHead), at(base, -0.4 * kHead)};
  canvas.fill(Mark::kAxis, head, palette::kInk);
  const Pixel label = at(tip + kLabel, 0);
  canvas.text(Mark::kAxis, {label.x + aside_of(axis) * unit, label.y + 0.33 * style.size}, axis.name, style);
}

}  // namespace hottel

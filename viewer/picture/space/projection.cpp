#include "viewer/picture/space/projection.h"

#include <array>
#include <numbers>

#include "geometry/space/visibility/convex_cut.h"
#include "kernel/plain_functions.h"

namespace hottel {

Direction3 rounded_way(const Point3& from, const Point3& to) {
  const Vector3 way = to - from;
  return {to_double(way.x), to_double(way.y), to_double(way.z)};
}

Projection3::Projection3(const Camera3& camera) : width_(camera.width), height_(camera.height) {
  forward_ = unit(rounded_way(camera.eye, camera.target));
  const Direction3 up{to_double(camera.up.x), to_double(camera.up.y), to_double(camera.up.z)};
  right_ = unit(cross(forward_, up));
  up_ = cross(right_, forward_);
  half_height_ = same_bits::tan(to_double(camera.field_of_view) * (std::numbers::pi / 360));
  half_width_ = half_height_ * width_ / height_;
}

// The normals of the half spaces whose directions are in the picture.
std::array<Direction3, 5> Projection3::inside() const {
  return {forward_, half_width_ * forward_ + right_, half_width_ * forward_ - right_, half_height_ * forward_ + up_,
          half_height_ * forward_ - up_};
}

Pixel Projection3::place(const Direction3& way, double out) const {
  return {(dot(way, right_) / out / half_width_ + 1) * width_ / 2,
          (1 - dot(way, up_) / out / half_height_) * height_ / 2};
}

PixelPolygon Projection3::picture(std::vector<Direction3> corners) const {
  for (const Direction3& normal : inside()) {
    corners = cut_convex(
        corners, [&](const Direction3& d) { return dot(d, normal); },
        [](const Direction3& a, const Direction3& b, double t) { return a + t * (b - a); });
    if (corners.size() < 3) return {};
  }
  PixelPolygon result;
  for (const Direction3& d : corners) {
    const double out = dot(d, forward_);
    if (!(out > 0)) return {};  // seen from the side
    result.push_back(place(d, out));
  }
  return result;
}

std::optional<std::array<Pixel, 2>> Projection3::line(Direction3 from, Direction3 to) const {
  for (const Direction3& normal : inside()) {
    const double a = dot(from, normal), b = dot(to, normal);
    if (a <= 0 && b <= 0) return std::nullopt;
    if (a < 0) from = from + (a / (a - b)) * (to - from);
    if (b < 0) to = to + (b / (b - a)) * (from - to);
  }
  const double out_from = dot(from, forward_), out_to = dot(to, forward_);
  if (!(out_from > 0) || !(out_to > 0)) return std::nullopt;
  return std::array{place(from, out_from), place(to, out_to)};
}

Direction3 Projection3::direction(const Pixel& place) const {
  return forward_ + (half_width_ * (2 * place.x / width_ - 1)) * right_ +
         (half_height_ * (1 - 2 * place.y / height_)) * up_;
}

AffineValue3 Projection3::dot_with(const Direction3& m) const {
  const double right = half_width_ * dot(m, right_), up = half_height_ * dot(m, up_);
  return {2 * right / width_, -2 * up / height_, dot(m, forward_) - right + up};
}

}  // namespace hottel

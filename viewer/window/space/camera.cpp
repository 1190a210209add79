#include "viewer/window/space/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernel/exact_double.h"
#include "kernel/plain_functions.h"

namespace hottel {
namespace {

constexpr double kLeastAngle = 1;                   // degrees between the way one looks and up or down
constexpr double kNearest = 1e-6, kFarthest = 1e3;  // sizes of the scene
constexpr double kMostWidening = 4;                 // of what is seen, in narrow frames
constexpr int kBits = 30;                           // of a coordinate, below the size of the scene

double radians(double degrees) { return degrees * (std::numbers::pi / 180); }

// Turned about an axis that is 1 long.
Direction3 about(const Direction3& axis, const Direction3& v, double angle) {
  return same_bits::cos(angle) * v + same_bits::sin(angle) * cross(axis, v) +
         (1 - same_bits::cos(angle)) * dot(axis, v) * axis;
}

}  // namespace

EyeCamera3::EyeCamera3(const Camera3& camera, double size)
    : eye_(place_of(camera.eye)),
      target_(place_of(camera.target)),
      up_(unit({to_double(camera.up.x), to_double(camera.up.y), to_double(camera.up.z)})),
      field_of_view_(camera.field_of_view),
      aspect_(static_cast<double>(camera.width) / camera.height),
      size_(size) {
  zoom(1);
  turn(0, 0);
}

// The way that is looked, turned by angles, but not up or down all the way.
Direction3 EyeCamera3::turned(double right_degrees, double up_degrees) const {
  const Direction3 way = about(up_, forward(), radians(-right_degrees));
  const double now = same_bits::acos(std::clamp(dot(way, up_), -1.0, 1.0));  // from up
  const double then = std::clamp(now - radians(up_degrees), radians(kLeastAngle), radians(180 - kLeastAngle));
  return unit(about(unit(cross(way, up_)), way, now - then));
}

void EyeCamera3::orbit(double right, double up) { eye_ = target_ - distance() * turned(-right, -up); }

void EyeCamera3::turn(double right, double up) { target_ = eye_ + distance() * turned(right, up); }

void EyeCamera3::pan(double right_length, double up_length) {
  const Direction3 way = right_length * right() + up_length * cross(right(), forward());
  eye_ = eye_ + way;
  target_ = target_ + way;
}

void EyeCamera3::zoom(double factor) {
  eye_ = target_ - std::clamp(distance() / factor, kNearest * size_, kFarthest * size_) * forward();
}

void EyeCamera3::zoom_to(const Direction3& place, double factor) {
  const double nearest = std::min(distance(), length(eye_ - place)), farthest = std::max(distance(), nearest);
  const double least = farthest / (kFarthest * size_), most = nearest / (kNearest * size_);
  const double by = std::clamp(factor, std::min(least, 1.0), std::max(most, 1.0));
  eye_ = place + (1 / by) * (eye_ - place);
  target_ = place + (1 / by) * (target_ - place);
}

void EyeCamera3::walk(double forward_length, double right_length, double up_length) {
  const Direction3 way = forward_length * cross(up_, right()) + right_length * right() + up_length * up_;
  eye_ = eye_ + way;
  target_ = target_ + way;
}

double EyeCamera3::half_height(FrameSize frame) const {
  const double narrower = std::clamp(aspect_ * frame.height / frame.width, 1.0, kMostWidening);
  return narrower * same_bits::tan(radians(to_double(field_of_view_)) / 2);
}

Rational EyeCamera3::field_of_view(FrameSize frame) const {
  const double half = half_height(frame);
  if (half == same_bits::tan(radians(to_double(field_of_view_)) / 2)) return field_of_view_;
  return exact_value(2 * same_bits::atan(half) * (180 / std::numbers::pi));
}

double EyeCamera3::length_of_pixel(FrameSize frame) const { return 2 * distance() * half_height(frame) / frame.height; }

double EyeCamera3::length_of_pixel_at(const Direction3& place, FrameSize frame) const {
  return length_of_pixel(frame) * dot(place - eye_, forward()) / distance();
}

Camera3 EyeCamera3::camera(FrameSize frame) const {
  const int bits = kBits - std::ilogb(size_);
  const auto exact = [bits](const Direction3& p) {
    const auto coordinate = [bits](double value) {
      return scaled_by_power_of_two(exact_value(std::nearbyint(std::ldexp(value, bits))), -bits);
    };
    return Point3{coordinate(p.x), coordinate(p.y), coordinate(p.z)};
  };
  Camera3 result;
  result.eye = exact(eye_);
  result.target = exact(target_);
  result.up = {exact_value(up_.x), exact_value(up_.y), exact_value(up_.z)};
  result.field_of_view = field_of_view(frame);
  result.width = std::min(frame.width, kMaxPixels);
  result.height = std::min(frame.height, kMaxPixels);
  return result;
}

std::optional<Pixel> EyeCamera3::at(const Direction3& place, FrameSize frame) const {
  const Direction3 way = place - eye_;
  const double out = dot(way, forward());
  if (!(out > 0)) return std::nullopt;
  const double per_length = frame.height / (2 * half_height(frame)) / out;
  return Pixel{frame.width / 2.0 + dot(way, right()) * per_length,
               frame.height / 2.0 - dot(way, cross(right(), forward())) * per_length};
}

Pointer3 EyeCamera3::pointer(const Pixel& mouse, FrameSize frame) const {
  Pointer3 result{.eye = eye_, .forward = forward(), .right = right(), .up = cross(right(), forward())};
  result.pixel = length_of_pixel(frame) / distance();
  result.at = {(mouse.x - frame.width / 2.0) * result.pixel, (frame.height / 2.0 - mouse.y) * result.pixel};
  return result;
}

std::optional<std::pair<Pixel, Pixel>> EyeCamera3::line(const Direction3& from, const Direction3& to,
                                                        FrameSize frame) const {
  const double near = kNearest * size_, out = dot(from - eye_, forward()), other = dot(to - eye_, forward());
  if (out < near && other < near) return std::nullopt;
  const auto cut = [&](const Direction3& a, double at_a, const Direction3& b, double at_b) {
    return at_a >= near ? a : a + ((near - at_a) / (at_b - at_a)) * (b - a);
  };
  const std::optional<Pixel> a = at(cut(from, out, to, other), frame), b = at(cut(to, other, from, out), frame);
  if (!a || !b) return std::nullopt;
  return std::pair(*a, *b);
}

}  // namespace hottel

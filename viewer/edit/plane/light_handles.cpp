#include "viewer/edit/plane/light_handles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernel/plain_functions.h"
#include "kernel/support/failure.h"
#include "viewer/edit/decimals.h"
#include "viewer/edit/light_list.h"
#include "viewer/edit/plane/rotation.h"

namespace hottel {
namespace {

double radians(const Rational& degrees) { return to_double(degrees) * std::numbers::pi / 180; }

double distance(const Place2& a, const Place2& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

// Where the axis points, counter-clockwise from the direction of x. [radians]
double axis_of(const LightPlace2& place) {
  return same_bits::atan2(to_double(place.direction.y), to_double(place.direction.x)) + radians(place.turned);
}

void move(LightPlace2& place, const Rational& dx, const Rational& dy) {
  const auto moved = [&](const Point2& p) { return Point2{p.x + dx, p.y + dy}; };
  place.position = moved(place.position);
  if (place.path)
    for (Point2& point : place.path->points) point = moved(point);
}

}  // namespace

LightShape2 light_shape(const Scene2& scene, std::uint32_t light, double arm) {
  HOTTEL_REQUIRE(light < scene.lights.size());
  const LightPlace2& where = scene.light_places[light];
  LightShape2 shape{.place = to_doubles(where.position), .is_spot = scene.lights[light].type == LightType::kSpot};
  if (!shape.is_spot) return shape;
  const double axis = axis_of(where), half = radians(scene.lights[light].half_angle());
  const auto at = [&](double angle) {
    return Place2{shape.place[0] + arm * same_bits::cos(angle), shape.place[1] + arm * same_bits::sin(angle)};
  };
  shape.axis = at(axis);
  shape.left = at(axis + half);
  shape.right = at(axis - half);
  return shape;
}

std::optional<LightHold> pick_light(const Scene2& scene, const Place2& place, double reach, double arm) {
  std::optional<LightHold> nearest;
  double least = reach;
  const auto offer = [&](std::uint32_t light, LightPart part, const Place2& at) {
    const double away = distance(at, place);
    if (!(nearest ? away < least : away <= least)) return;
    least = away;
    nearest = LightHold{light, part};
  };
  const auto count = static_cast<std::uint32_t>(scene.lights.size());
  for (std::uint32_t k = 0; k < count; ++k)
    if (!scene.lights[k].is_sun()) offer(k, LightPart::kPlace, light_shape(scene, k, arm).place);
  for (const auto& [part, member] : {std::pair(LightPart::kAxis, &LightShape2::axis),
                                     {LightPart::kLeft, &LightShape2::left},
                                     {LightPart::kRight, &LightShape2::right}})
    for (std::uint32_t k = 0; k < count; ++k)
      if (const LightShape2 shape = light_shape(scene, k, arm); shape.is_spot) offer(k, part, shape.*member);
  return nearest;
}

Scene2 drag_light(const Scene2& scene, const LightHold& hold, const Place2& to, int decimals) {
  Scene2 edited = begin_light_edit(scene, hold.light);
  LightPlace2& place = edited.light_places[hold.light];
  const Point2 goal{rounded_decimal(to[0], decimals), rounded_decimal(to[1], decimals)};
  const Point2 way{goal.x - place.position.x, goal.y - place.position.y};
  if (hold.part == LightPart::kPlace) {
    move(place, way.x, way.y);
    return edited;
  }
  if (way.x == 0 && way.y == 0) return scene;
  if (hold.part == LightPart::kAxis) {
    place.direction = way;
    place.turned = 0;
    return edited;
  }
  Light& light = edited.lights[hold.light];
  const double angle = same_bits::atan2(to_double(way.y), to_double(way.x)) - axis_of(place);
  const double degrees = std::abs(std::remainder(angle, 2 * std::numbers::pi)) * 180 / std::numbers::pi;
  light.focus = std::clamp<Rational>(rounded_decimal(degrees, 0), 1, light.falloff > 0 ? 90 : 180);
  return edited;
}

Scene2 move_light(const Scene2& scene, std::uint32_t light, const Rational& dx, const Rational& dy) {
  Scene2 edited = begin_light_edit(scene, light);
  move(edited.light_places[light], dx, dy);
  return edited;
}

Scene2 turn_light(const Scene2& scene, std::uint32_t light, const Rational& degrees) {
  Scene2 edited = begin_light_edit(scene, light);
  if (edited.lights[light].type == LightType::kPoint) return scene;
  const Point2& direction = edited.light_places[light].direction;
  const int decimals = kDirectionDigits - decades(std::max(abs(direction.x), abs(direction.y)));
  edited.light_places[light].direction = Rotation2({}, degrees, decimals)(direction);
  return edited;
}

Scene2 duplicate_light(const Scene2& scene, std::uint32_t light, const Rational& dx, const Rational& dy) {
  HOTTEL_REQUIRE(light < scene.lights.size());
  LightPlace2 place = scene.light_places[light];
  move(place, dx, dy);
  return copy_light(scene, light, std::move(place));
}

}  // namespace hottel

#include "viewer/edit/space/light_handles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "geometry/light_motion.h"
#include "kernel/exact_double.h"
#include "kernel/plain_functions.h"
#include "kernel/support/failure.h"
#include "viewer/edit/decimals.h"
#include "viewer/edit/light_list.h"
#include "viewer/edit/space/placing.h"

namespace hottel {
namespace {

constexpr int kRim = 32;                   // corners of the rim of a beam
constexpr double kPixelsPerDegree = 0.02;  // that a focus far from the one before has to be nearer to the mouse

double radians(const Rational& degrees) { return to_double(degrees) * std::numbers::pi / 180; }

double distance(const Pixel& a, const Pixel& b) { return std::hypot(a.x - b.x, a.y - b.y); }

// A light, its axis and what is left of it, each 1 long, and how far its handles are.
struct Beam {
  Direction3 place, axis, left;
  double arm = 0;

  // The end of a border at an angle from the axis; to the left where that is above 0.
  Direction3 border(double angle) const {
    return place + arm * (same_bits::cos(angle) * axis + same_bits::sin(angle) * left);
  }
};

// 1 long, whatever the length of the vector. REQUIRES that it is not zero.
Direction3 direction_of(const Vector3& v) {
  const Rational size = std::max<Rational>({abs(v.x), abs(v.y), abs(v.z)});
  return unit({to_double(v.x / size), to_double(v.y / size), to_double(v.z / size)});
}

Beam beam_of(const LightPlace3& light, const Pointer3& pointer) {
  Beam beam{.place = place_of(light.position), .axis = direction_of(light.direction), .left = {}};
  beam.arm = pointer.arm * pointer.length_of_pixel(beam.place);
  // At right angles to the axis and to the way to the light: there the cone has its outline, as far as it is small.
  const Direction3 across = cross(beam.place - pointer.eye, beam.axis);
  beam.left = length(across) > 1e-9 * length(beam.place - pointer.eye) ? unit(across) : -pointer.right;
  return beam;
}

void move(LightPlace3& place, const Vector3& way) {
  const auto moved = [&](const Point3& p) { return Point3{p.x + way.x, p.y + way.y, p.z + way.z}; };
  place.position = moved(place.position);
  if (place.path)
    for (Point3& point : place.path->points) point = moved(point);
}

// The direction from a light to where the ray of the mouse meets the sphere of its handles, or comes nearest to it.
Direction3 direction_on_sphere(const Beam& beam, const Pointer3& pointer) {
  const Direction3 ray = unit(pointer.way_to(pointer.at)), way = beam.place - pointer.eye;
  const double nearest = dot(ray, way);
  const Direction3 beside = pointer.eye + nearest * ray - beam.place;
  const double half_chord = std::sqrt(std::max(0.0, beam.arm * beam.arm - dot(beside, beside)));
  const bool is_farther = dot(beam.axis, way) >= 0;
  return unit(beside + (is_farther ? half_chord : -half_chord) * ray);
}

void aim(LightPlace3& place, const Pointer3& pointer) {
  const int decimals = decimals_at_place(place_of(place.position), pointer);
  const Vector3 way = rounded_place(*pointer.aim, place.position, decimals) - place.position;
  if (!way.is_zero()) place.direction = way;
}

void turn_to_mouse(LightPlace3& place, const Pointer3& pointer) {
  const Direction3 d = direction_on_sphere(beam_of(place, pointer), pointer);
  const auto part = [](double value) { return rounded_decimal(value, kDragDecimals); };
  if (std::isfinite(d.x) && std::isfinite(d.y) && std::isfinite(d.z))
    place.direction = {part(d.x), part(d.y), part(d.z)};
}

// The focus at which a border is seen nearest to the mouse.
Rational focus_at_mouse(const Light& light, const Beam& beam, const Pointer3& pointer, bool is_left) {
  const double before = to_double(light.half_angle());
  int nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int degrees = 1; degrees <= (light.falloff > 0 ? 90 : 180); ++degrees) {
    const Direction3 end = beam.border((is_left ? 1 : -1) * radians(degrees));
    if (!(pointer.depth(end) > 0)) continue;
    const double away =
        distance(pointer.seen(end), pointer.at) / pointer.pixel + kPixelsPerDegree * std::abs(degrees - before);
    if (!(away < least)) continue;
    least = away;
    nearest = degrees;
  }
  return nearest > 0 ? exact_value(nearest) : light.focus;
}

bool is_in_front(const LightPlace3& place, const Pointer3& pointer) {
  return pointer.depth(place_of(place.position)) > 1e-12 * length(place_of(place.position) - pointer.eye);
}

}  // namespace

std::optional<LightShape3> light_shape(const Scene3& scene, std::uint32_t light, const Pointer3& pointer) {
  HOTTEL_REQUIRE(light < scene.lights.size());
  const LightPlace3& where = scene.light_places[light];
  if (scene.lights[light].is_sun() || !is_in_front(where, pointer)) return std::nullopt;
  LightShape3 shape{.place = place_of(where.position), .is_spot = scene.lights[light].type == LightType::kSpot};
  if (!shape.is_spot) return shape;
  const Beam beam = beam_of(where, pointer);
  const double half = radians(scene.lights[light].half_angle());
  shape.axis = beam.border(0);
  shape.left = beam.border(half);
  shape.right = beam.border(-half);
  const Direction3 middle = beam.place + beam.arm * same_bits::cos(half) * beam.axis,
                   other = cross(beam.axis, beam.left);
  for (int k = 0; k < kRim; ++k) {
    const double angle = 2 * std::numbers::pi * k / kRim;
    shape.rim.push_back(middle + beam.arm * same_bits::sin(half) *
                                     (same_bits::cos(angle) * beam.left + same_bits::sin(angle) * other));
  }
  return shape;
}

std::optional<LightHold> pick_light(const Scene3& scene, const Pointer3& pointer) {
  std::optional<LightHold> nearest;
  double least = pointer.reach;
  const auto offer = [&](std::uint32_t light, LightPart part, const Direction3& at) {
    if (!(pointer.depth(at) > 0)) return;
    const double away = distance(pointer.seen(at), pointer.at) / pointer.pixel;
    if (!(nearest ? away < least : away <= least)) return;
    least = away;
    nearest = LightHold{light, part};
  };
  for (const auto& [part, member] : {std::pair(LightPart::kPlace, &LightShape3::place),
                                     {LightPart::kAxis, &LightShape3::axis},
                                     {LightPart::kLeft, &LightShape3::left},
                                     {LightPart::kRight, &LightShape3::right}})
    for (std::uint32_t k = 0; k < scene.lights.size(); ++k) {
      const std::optional<LightShape3> shape = light_shape(scene, k, pointer);
      if (shape && (part == LightPart::kPlace || shape->is_spot)) offer(k, part, (*shape).*member);
    }
  return nearest;
}

Scene3 drag_light(const Scene3& scene, const LightHold& hold, const Pointer3& pointer) {
  Scene3 edited = begin_light_edit(scene, hold.light);
  LightPlace3& place = edited.light_places[hold.light];
  if (!is_in_front(place, pointer)) return scene;
  const Direction3 from = place_of(place.position);
  if (hold.part == LightPart::kPlace) {
    const Direction3 to = pointer.along_axis ? from + way_along_seen_axis(from, pointer) : place_beside(from, pointer);
    if (!is_within_reach_of_hands(from, to, pointer)) return scene;
    const int decimals = decimals_at_place(from, pointer);
    move(place, rounded_place(to, place.position, decimals) - place.position);
  } else if (hold.part == LightPart::kAxis) {
    pointer.aim ? aim(place, pointer) : turn_to_mouse(place, pointer);
  } else {
    Light& light = edited.lights[hold.light];
    light.focus = focus_at_mouse(light, beam_of(place, pointer), pointer, hold.part == LightPart::kLeft);
  }
  return edited;
}

Scene3 move_light(const Scene3& scene, std::uint32_t light, const Vector3& way) {
  Scene3 edited = begin_light_edit(scene, light);
  move(edited.light_places[light], way);
  return edited;
}

Scene3 turn_light(const Scene3& scene, std::uint32_t light, const Rational& degrees) {
  Scene3 edited = begin_light_edit(scene, light);
  if (edited.lights[light].type == LightType::kPoint) return scene;
  Vector3& direction = edited.light_places[light].direction;
  const Rational angle = within_a_turn(degrees);
  if (Rational(angle / 90).get_den() == 1) {
    for (Rational rest = angle; rest > 0; rest -= 90) direction = {Rational(-direction.y), direction.x, direction.z};
    return edited;
  }
  const std::vector<double> axis = turned({direction.x, direction.y, direction.z}, {0, 0, angle});
  const auto part = [&](std::size_t k) { return rounded_decimal(axis[k], kTurnDecimals); };
  direction = {part(0), part(1), part(2)};
  return edited;
}

}  // namespace hottel

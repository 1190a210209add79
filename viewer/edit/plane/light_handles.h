// Lights of the plane under a hand: what of them can be taken hold of, and where a hand drags it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/plane/scene/scene.h"
#include "viewer/edit/light_hold.h"
#include "viewer/edit/plane/local_edges.h"

namespace hottel {

// Where a light is drawn. left, right: of the axis, as seen along it.
struct LightShape2 {
  Place2 place{};
  bool is_spot = false;  // the rest is a spot's
  Place2 axis{}, left{}, right{};
};

// Digits of a direction that was turned: an axis so far off is not seen.
inline constexpr int kDirectionDigits = 6;

// Returns the light with handles at `arm` from it. [scene length] REQUIRES no sun: it has none, and is not picked.
LightShape2 light_shape(const Scene2& scene, std::uint32_t light, double arm);

// Returns what of a light is nearest to a place, within reach; of what is equally near, places before axes before
// borders, and lights in their order. In doubles. COST: linear in the lights.
std::optional<LightHold> pick_light(const Scene2& scene, const Place2& place, double reach, double arm);

// Edits of lights, beside those of light_list.h: a scene goes in, another one comes out, as scene_edits.h says of all
// of them. Each throws ContractViolation for an index out of range.

// Moves what is held to a place that is rounded to decimals.
//
//   (1) a light takes its path along
//   (2) an axis goes to the direction of that place, exactly; where that is the light's own place nothing changes
//   (3) a border makes the focus the angle between the axis and that place: in whole degrees, 1 at least, and 180, or
//       90 where the light falls off, at most
Scene2 drag_light(const Scene2& scene, const LightHold& hold, const Place2& to, int decimals);

Scene2 move_light(const Scene2& scene, std::uint32_t light, const Rational& dx, const Rational& dy);

// Turns the axis counter-clockwise; of a point light, nothing.
//
//   (4) by multiples of 90 degrees exactly; otherwise the direction is rounded to kDirectionDigits digits
Scene2 turn_light(const Scene2& scene, std::uint32_t light, const Rational& degrees);

// Adds a copy, moved by that (copy_light).
Scene2 duplicate_light(const Scene2& scene, std::uint32_t light, const Rational& dx, const Rational& dy);

}  // namespace hottel

// Lights in space under a hand: what of them can be taken hold of, and where a hand drags it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/space/scene/scene.h"
#include "viewer/edit/light_hold.h"
#include "viewer/edit/space/pointer.h"

namespace hottel {

// Where a light is drawn. left, right: of the axis, as the eye sees it, at right angles to the way it looks.
struct LightShape3 {
  Direction3 place{};
  bool is_spot = false;  // the rest is a spot's
  Direction3 axis{}, left{}, right{};
  std::vector<Direction3> rim{};  // of the cone of its beam, through left and right
};

// Decimals of a direction that a hand turns: of a vector 1 long, or as long as its largest component.
inline constexpr int kDragDecimals = 3, kTurnDecimals = 6;

// Returns the light with handles at pointer.arm pixels from it; nothing where it is not in front of the eye, and for
// a sun, which is nowhere.
std::optional<LightShape3> light_shape(const Scene3& scene, std::uint32_t light, const Pointer3& pointer);

// Returns what of a light is seen nearest to the mouse, within reach; of what is equally near, places before axes
// before borders, and lights in their order. What hides a light does not hide its handles. In doubles. COST: linear in
// the lights.
std::optional<LightHold> pick_light(const Scene3& scene, const Pointer3& pointer);

// Edits of lights, beside those of light_list.h. Each throws ContractViolation for an index out of range.

// Moves what is held to where the hand points.
//
//   (1) a light moves in the plane through it that is parallel to the picture, or along x, y or z: that of them which
//       is seen to go most the same way. It takes its path along
//   (2) coordinates are short decimals, finer than a pixel (decimals_at); one that changes by less than half of the
//       last of them stays, with all digits that it has
//   (3) an axis points at pointer.aim, exactly at a place rounded as in (2). Without one its end stays under the mouse,
//       on the sphere of its handle: on the side, nearer or farther than the light, on which it is, and at the rim
//       where the mouse is beyond. Its direction is rounded to kDragDecimals
//   (4) a border makes the focus the whole number of degrees, 1 at least, and 180, or 90 where the light falls off, at
//       most, at which it is seen nearest to the mouse
//   (5) what cannot be had, as of a light behind the eye, changes nothing
Scene3 drag_light(const Scene3& scene, const LightHold& hold, const Pointer3& pointer);

Scene3 move_light(const Scene3& scene, std::uint32_t light, const Vector3& way);

// Turns the axis about z, counter-clockwise as seen from above; of a point light, nothing.
//
//   (6) by multiples of 90 degrees exactly; otherwise the direction is rounded to kTurnDecimals
Scene3 turn_light(const Scene3& scene, std::uint32_t light, const Rational& degrees);

}  // namespace hottel

// Lights changed by a key, or as they are typed.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "geometry/light.h"

namespace hottel {

// Changes a light as the material is changed that is called the same (edit_material): "less emission" and "more
// emission" its power by a quarter, "less reflectivity" and "more reflectivity" the focus of its beam by a fifth, to
// two digits, "colour" its colour to the next of six paints, as strong.
//
//   (1) what comes out is valid (light_problem) where the light was: focus is from 0.1 to 180, to 90 where it falls off
//   (2) a point light of which the focus is asked for becomes a spot; a sun has none, and stays
// REQUIRES is_material_edit(name).
void edit_light(Light& light, std::string_view name);

// Degrees a second of a light that is set spinning.
inline constexpr int kSpin = 30;

// Changes a light or its rotation: as edit_light(light, name) does, and "spin" sets a spot that stands still turning by
// kSpin, counter-clockwise, in space about z, and stops one that turns; so of the direction of a sun. A point light has
// no axis to turn. rotation: of the axis, in degrees a second; one number, or three.
void edit_light(Light& light, std::span<Rational> rotation, std::string_view name);

// Whether edit_light takes a name: is_material_edit, or "spin".
bool is_light_edit(std::string_view name);

// Why such an edit has changed nothing.
std::string why_light_stays(std::string_view name);

// Returns what read_light reads: "power 6 5 3; focus 25; falloff 2; rotation 30", of a point light its power, and of a
// sun "irradiance 800; rotation 15".
std::string light_text(const Light& light, std::span<const Rational> rotation);

// Reads that into a light and its rotation, some or all of it; returns what is wrong with it, and then has changed
// nothing.
//
//   (3) a number that is typed as it is shown keeps all the digits that it has
//   (4) a point light that is given a focus, a falloff or a rotation becomes a spot; a sun has irradiance and rotation
//       only
std::string read_light(const std::string& text, Light& light, std::span<Rational> rotation);

}  // namespace hottel

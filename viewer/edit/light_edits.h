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
//   (2) a point light of which the focus is asked for becomes a spot
// REQUIRES is_material_edit(name).
void edit_light(Light& light, std::string_view name);

// Returns what read_light reads: "power 6 5 3; focus 25; falloff 2; rotation 30", and of a point light its power.
// rotation: of the axis, in degrees a second; one number, or three.
std::string light_text(const Light& light, std::span<const Rational> rotation);

// Reads that into a light and its rotation, some or all of it; returns what is wrong with it, and then has changed
// nothing.
//
//   (3) a number that is typed as it is shown keeps all the digits that it has
//   (4) a point light that is given a focus, a falloff or a rotation becomes a spot
std::string read_light(const std::string& text, Light& light, std::span<Rational> rotation);

}  // namespace hottel

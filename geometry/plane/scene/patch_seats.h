// How patches of the plane are put onto what they lie on.
#pragma once

#include "geometry/plane/scene/scene.h"

namespace hottel {

// Puts patches onto what they lie on: their ends onto the line of the base, exactly, where both are near enough to it
// (is_within_seat, by the lengths of the two); and what then is beyond an end of the base by no more than that onto the
// end. Pieces of a polyline that followed each other do so after.
//
//   (1) a patch whose ends lie on the line of its base and within it stays as it is; so does one that is farther off
//   (2) patches on patches come after what they lie on
//
// `unit` is what the last digit of the coordinates stands for, 0 where they have none.
void seat_patches(Scene2& scene, const Rational& unit);

// Throws InputError naming file, line, patch, base and place, with the remedy, for a patch that does not lie on the
// line of its base exactly, that looks the other way, or that leaves its base. REQUIRES validate_bases(scene). COST:
// for each patch linear in the edges of its base.
void validate_patches(const Scene2& scene);

}  // namespace hottel

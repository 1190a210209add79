// How patches of space are put onto what they lie on.
#pragma once

#include "geometry/space/scene/scene.h"

namespace hottel {

// Puts patches onto what they lie on: their corners into the plane of the base, exactly, where all are near enough to
// it (is_within_seat, by the diameters of the two); and those that then are beside the base by no more than that onto
// the nearest point of its border.
//
//   (1) a patch in the plane of its base and within it stays as it is; so does one that is farther off
//   (2) a nearly plane base is its facets, each in a plane of its own; a patch on several of them is cut as they are
//       (draped)
//   (3) patches on patches come after what they lie on
//
// `unit` is what the last digit of the coordinates stands for, 0 where they have none.
void seat_patches(Scene3& scene, const Rational& unit);

// Throws InputError naming file, line, patch, base and place, with the remedy, for a patch that does not lie in the
// plane of its base exactly, that looks the other way, or that leaves its base. REQUIRES validate_bases(scene), and
// polygons without a problem. COST: for each patch linear in the polygons of its base, and a PlaneTriangulation3 of
// those near it.
void validate_patches(const Scene3& scene);

}  // namespace hottel

// A scene in space whose gaps are closed.
#pragma once

#include <string>

#include "geometry/element.h"
#include "geometry/space/check/repaired_scene.h"

namespace hottel {

// Returns the scene as it is, without any step.
Repair3 unrepaired(const Scene3& scene);

// Returns what an element of the repaired scene was called before; factor_changes() asks for it.
std::string former_name(const Repair3& repair, const Element& element);

// Drops doubles, then reverses what is upside down and what is inside out: drop_doubles, reverse_upside_down and
// reverse_inside_out. No corner moves.
void tidy(Repair3& repair);

// Returns the scene, tidied, with corners that are within `distance` of each other merged (into the one listed first),
// and corners within `distance` of an edge or a face of a polygon put exactly onto it, edges first; what comes of that
// is tidied too.
//
//   (1) no corner moves farther than `distance`; without a gap, and with nothing to tidy, the scene stays as it is
//   (2) a corner that lies on a polygon exactly, and stays within reach of it, lies on it afterwards
//   (3) every polygon is one (polygon_problem). One that would not be plane any more becomes triangles (NAME[0],
//       NAME[1], ...: triangulated); where that cannot be, none of its corners moves (not-repaired)
//   (4) corners of masks and patches, and of what they lie on, stay where they are
//   (5) polygons without an area left are dropped; names, materials, order and all else stay
//   (6) of contacts, shapes and meshes no more is found afterwards than in the tidied scene, and no more that is not a
//       note (notes of needles and crossings count, others do not: they tell how things are that touch); and to close
//       the gaps of what is returned does nothing. Where it would, what moves together stays as it was (not-repaired)
// Edges that pass by each other are left as they are.
// REQUIRES a valid scene and distance > 0. COST: O(n log n), and exact arithmetic near corners; once more for each
// polygon of (3) that keeps its corners.
Repair3 close_gaps(const Scene3& scene, const Rational& distance);

// Reverses polygons that certainly have their fronts on the wrong side (Meshes3::reversed), with the patches on them,
// and adds a step for each. Those with a material on the back stay as they are.
void reverse_upside_down(Repair3& repair);

// Reverses the closed parts of meshes that are inside out and may be bodies (Shell3), with the patches on them, and
// adds a step for each.
void reverse_inside_out(Repair3& repair);

// Drops what another polygon, listed before, is as well: the same corners the same way round, and the same materials.
// Adds a step for each.
void drop_doubles(Repair3& repair);

}  // namespace hottel

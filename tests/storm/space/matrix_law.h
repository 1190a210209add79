// What must hold of the whole matrix of a scene of polygons.
#pragma once

#include <cstdint>
#include <string>

#include "geometry/space/scene/scene.h"
#include "tests/storm/space/lattice_scene.h"

namespace hottel::storm {

// The polygons as a scene: each has a material on both of its sides, and is a group of its own.
Scene3 scene_of_polygons_3(const Polygons3& polygons);

// What is wrong with a matrix, or nothing; or why there is none: a pair could not be measured, which is told by name.
struct MatrixAnswer3 {
  std::string wrong, refusal;
};

// Returns the answer for the view factors of all pairs of sides, the sky integrated, within 1e-12 of the smaller area,
// or as far as doubles go:
//
//   (1) each row sums to 1 within the errors that its entries state, and its bounds hold 1
//   (2) told by closure the sky is the same within the same, is seen from the same sides, and no row that is checked
//       differs by more than it states
//
// In some small scenes, drawn by `chance`, of elements, 2 x 2 a side. Of towns (more than 40 polygons) twelve rows, and
// not (2).
MatrixAnswer3 matrix_answer_3(const Polygons3& polygons, std::uint64_t chance);

}  // namespace hottel::storm

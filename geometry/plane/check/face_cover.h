// What is left of the faces of a scene beside its solids.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/scene_names.h"

namespace hottel {

// What is left of each face (by Face::number()) and what solids do to it.
//
//   (1) has_area: the face owns a side of a piece, or is one of two that claim it
//   (2) covered_by: the first listed group with a solid that the face looks into somewhere; Solids2::kNone: nowhere
//   (3) holder, by group: the first listed other group that holds it in the interior of its solid; Solids2::kNone
//       where there is none. A group is held when some of its surfaces are covered on both sides, and the others are
//       too, or lie on the border of the solid of another group from within
//
// COST: linear in the sides of pieces.
struct FaceCover2 {
  std::vector<char> has_area;
  std::vector<std::uint32_t> covered_by;
  std::vector<std::uint32_t> holder;

  FaceCover2() = default;
  // REQUIRES the arrangement of the scene, divided or not; conflicts may be kept.
  FaceCover2(const Scene2& scene, const Arrangement2& arrangement);
};

// Throws RequestError, naming the solid, where a face looks into solids all along.
void require_free(const PreparedScene2& prepared, const Face& face);

// Throws RequestError, naming the solid or the patch, where a face looks into a solid or gives way to a patch at the
// place t: just after it, or just before it at the end of the face. REQUIRES: 0 <= t <= 1.
void require_free_at(const PreparedScene2& prepared, const Face& face, const Rational& t);

}  // namespace hottel

// Very small angles between surfaces.
#pragma once

#include <vector>

#include "geometry/plane/arrangement/arrangement.h"
#include "geometry/plane/check/finding.h"

namespace hottel {

// An angle is a needle when its tangent is below 1 / kNeedlePart: a twentieth of a degree. It decides only what
// is worth telling.
inline constexpr int kNeedlePart = 1024;

// Free space between two pieces that meet at a vertex in a small angle.
struct Needle2 {
  VertexId at;
  std::size_t right, left;  // pieces: the angle lies counter-clockwise of `right`
  double degrees;           // about
};

// Returns the needles of an arrangement, by vertex and then counter-clockwise.
//
//   (1) whether an angle is a needle is decided exactly: its tangent is positive and below 1 / kNeedlePart
//   (2) nothing stands in the angle near the vertex, and it is not within a solid
//
// COST: linear in the triangles; exact arithmetic where doubles do not tell.
std::vector<Needle2> find_needles(const Arrangement2& arrangement);

// What is worth telling about them. Kind: needle, a note.
Findings2 needle_findings(const Scene2& scene, const Arrangement2& arrangement);

}  // namespace hottel

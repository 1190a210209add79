// What is worth telling about what faces see in space.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/space/check/finding.h"
#include "geometry/space/check/mesh_findings.h"

namespace hottel {

// An opening is told in a scene that makes no promise when less than this part of what the faces send out goes through.
inline constexpr double kLeakPart3 = 1.0 / 64;

// Returns what is worth telling about what faces see. Kinds:
//
//   not-closed       an error: the scene promises to be closed, and fronts with a material see the sky
//   opening          a note: it makes no such promise, and nearly is (kLeakPart3)
//   inside-out       a warning: the fronts of a closed mesh look inward, where they see nothing but each other and
//                    nothing emits, and others see their black backs. A note where nobody does
//   black-back       a warning, once a back: a face with a material sees a back without one; with the largest F that is
//                    lost and the face that loses it. Not of backs that inside-out or upside-down tells of. What to do
//                    depends on the group: it is to be closed, or it is, with its fronts on the wrong side
//   sees-only-backs  a note: a face with a material sees nothing but backs without one
//   covered          a note, a warning where it emits: nothing is left of a face with a material (it has no row)
//   sees-only-sky    a note, of a whole group: none of its faces sees anything but the sky
//
// That something is seen at all is decided by signs (an entry of the matrix); how much is told as it was measured.
// `is_whole`: the matrix has all that is seen. Else it may lack entries (of middle_views): then nothing is told that
// would follow from what is not seen.
// REQUIRES the matrix of the scene by faces, and its meshes. COST: a few passes over the matrix.
Findings3 visibility_findings(const Scene3& scene, const Meshes3& meshes, const ExchangeMatrix& matrix,
                              bool is_whole = true);

}  // namespace hottel

// What is worth telling about what faces see.
#pragma once

#include "geometry/exchange_matrix.h"
#include "geometry/plane/check/finding.h"
#include "geometry/plane/prepared/prepared_scene.h"

namespace hottel {

// An opening is told in a scene that makes no promise when it is narrower than this part of the walls behind it.
inline constexpr double kLeakPart = 1.0 / 64;

// Returns what is worth telling about what faces see. Kinds: not-closed, opening, sees-only-sky.
//
//   not-closed      a promise of the scene is broken: an error, one for each opening
//   opening         told in a scene that makes no such promise, where it is narrow (kLeakPart)
//   sees-only-sky   told of a whole polyline, or of an edge of its own
//
// REQUIRES: `prepared` is not divided; the exact matrix of the scene, by faces or by elements.
Findings2 visibility_findings(const PreparedScene2& prepared, const ExchangeMatrix& matrix);

}  // namespace hottel

// What is worth telling about what faces see.
#pragma once

#include "geometry/exchange_matrix.h"
#include "geometry/plane/arrangement/prepared_scene.h"
#include "geometry/plane/check/finding.h"

namespace hottel {

// An opening is told in a scene that makes no promise when it is narrower than this part of the walls behind it.
inline constexpr double kLeakPart = 1.0 / 64;

// Kinds: not-closed (error; one for each opening), opening, sees-only-sky (a whole polyline, or an
// edge of its own). REQUIRES: `prepared` is not divided; the exact matrix of the scene, by faces or by elements.
Findings2 sight_findings(const PreparedScene2& prepared, const ExchangeMatrix& matrix);

// Throws RequestError, naming the first front, where a scene promises to be closed and a front with a material sees the
// sky. REQUIRES the exact matrix of the scene.
void require_closed(const Scene2& scene, const ExchangeMatrix& matrix);

}  // namespace hottel

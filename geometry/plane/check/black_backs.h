// Backs without a material that take light away.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/plane/arrangement/free_regions.h"
#include "geometry/plane/check/finding.h"
#include "geometry/plane/prepared/prepared_scene.h"

namespace hottel {

// Kind: black-back. A back without a material that a face with one sees, once a group, with the largest F that is lost
// there and the face that loses it. The remedy is "behind": "solid" where that would be accepted, else a "back"; where
// faces would be covered wholly by it, both are said.
//
//   (1) `surfaces` are those of the findings, in the order of the scene
//   (2) nothing is told of surfaces that are in `told` (by surface): something else was said of their backs
// REQUIRES a matrix of the scene, by faces or by elements. COST: a pass over the matrix; where there is something to
// tell, the regions too, and linear in the sides of pieces.
struct BlackBacks2 {
  Findings2 findings;
  std::vector<std::uint32_t> surfaces;
};
BlackBacks2 black_backs(const PreparedScene2& prepared, const FreeRegions2& regions, const ExchangeMatrix& matrix,
                        const std::vector<char>& told);

// Returns whether some face with a material sees a back without one.
bool sees_black_backs_2(const ExchangeMatrix& matrix);

}  // namespace hottel

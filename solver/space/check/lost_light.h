// What warns of light that is lost in a scene in space.
#pragma once

#include "geometry/exchange_matrix.h"
#include "geometry/space/check/finding.h"
#include "geometry/space/scene/scene.h"

namespace hottel {

// The findings of kind black-back (visibility_findings), warnings of backs without a material that faces with one see,
// and of kind inside-out (tell_inside_out). REQUIRES the exact matrix of the scene, by faces or elements. COST: a pass
// over the matrix, and that of inside_out_shells; where light is lost, that of find_meshes.
Findings3 lost_light_warnings(const Scene3& scene, const ExchangeMatrix& matrix);

}  // namespace hottel

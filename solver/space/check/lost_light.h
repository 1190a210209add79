// What warns of light that is lost in a scene in space.
#pragma once

#include "geometry/exchange_matrix.h"
#include "geometry/space/check/finding.h"
#include "geometry/space/scene/scene.h"

namespace hottel {

// The findings of kind black-back (sight_findings): a warning for each back without a material that a face with one
// sees. REQUIRES the exact matrix of the scene, by faces or elements.
// COST: a pass over the matrix; where there is any, that of find_meshes.
Findings3 lost_light_warnings(const Scene3& scene, const ExchangeMatrix& matrix);

}  // namespace hottel

// Values that are blended over flat surfaces, as runs over the parts of elements.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/space/prepared/prepared_scene.h"
#include "solver/space/light/gathered_light.h"
#include "viewer/picture/space/smooth_mesh.h"

namespace hottel {

// Returns how values run over each part of the table that the mesh was made of, blended as SmoothMesh3 says, but that
// the middle of a part has what makes the mean of the part that of its element. Where that is not in the range from 0
// to twice the value of the element, it has the nearer end of that range. Up to three channels.
//
// REQUIRES values by element and channel, not negative. COST: linear.
std::vector<PartRun3> smooth_runs_3(const PreparedScene3& prepared, const ElementTable3& table, const SmoothMesh3& mesh,
                                    std::span<const double> values, std::size_t channels);

}  // namespace hottel

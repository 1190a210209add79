// Values that are blended over flat surfaces, as runs over the parts of elements.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/space/prepared/prepared_scene.h"
#include "solver/space/light/gathered_light.h"
#include "viewer/picture/space/smooth_mesh.h"

namespace hottel {

// Returns how values run over each part of the table that the mesh was made of: linearly from the middle of a part to
// those at its ring. The middle has what makes the mean of the part that of its element; where that is not in the range
// from 0 to twice the value of the element, it has the nearer end of that range. Up to three channels.
//
// REQUIRES values by corner of the mesh and channel, and by element and channel, not negative. COST: linear.
std::vector<PartRun3> smooth_runs_3(const PreparedScene3& prepared, const ElementTable3& table, const SmoothMesh3& mesh,
                                    std::span<const double> at_corners, std::span<const double> values,
                                    std::size_t channels);

}  // namespace hottel

// Light of a face on texels: what a lightmap has.
#pragma once

#include <cstdint>
#include <functional>

#include "geometry/face.h"
#include "geometry/space/scene/scene.h"
#include "solver/space/light/illumination_grid.h"
#include "viewer/picture/space/gathered_source.h"

namespace hottel {

// Returns the texels of a face as cells: from its first corner u goes to the second, v to the last. A point (s, t) of
// `visibility --on` is at s u + t v. Throws UsageError where the polygon is plane only nearly, or the face has no
// material.
Grid3 texel_grid_3(const Scene3& scene, const Face& face, std::uint32_t nu, std::uint32_t nv);

// Returns the light at the middle of each texel, gathered, direct light included: what the source responds with, by its
// channels. NaN: the middle is no place of the face.
//
//   (1) what is seen of each middle, by faces and by lights, is decided exactly; a texel does not depend on the others
//
// progress: fraction done; may throw to stop. COST: that of GatheredLight3 for each texel.
IlluminationGrid3 texels_3(const PreparedScene3& prepared, const GatheredSource3& source, const Face& face,
                           const Grid3& grid, const std::function<void(double)>& progress = {});

}  // namespace hottel

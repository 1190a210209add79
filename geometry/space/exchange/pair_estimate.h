// About how many pairs of elements see each other in space, told from the polygons alone.
#pragma once

#include <span>

#include "geometry/counted_faces.h"
#include "geometry/space/scene/scene.h"

namespace hottel {

// The faces of a scene with their elements counted. COST: linear in the corners of polygons that are divided.
std::vector<CountedFace> counted_faces_3(const Scene3& scene, Granularity granularity);

// Samples pairs of elements, and asks in doubles whether some line between two points of them, one of some that are
// drawn, meets no polygon. Overlaps and solids are not looked at: it may be wrong either way.
// REQUIRES as sampled_pairs. COST: a quarter of a second at most, however many elements there will be.
SampledPairs estimated_pairs_3(const Scene3& scene, std::span<const CountedFace> faces);

}  // namespace hottel

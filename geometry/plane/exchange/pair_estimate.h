// About how many pairs of elements see each other in the plane, told from the edges alone.
#pragma once

#include <span>

#include "geometry/counted_faces.h"
#include "geometry/plane/scene/scene.h"

namespace hottel {

// The faces of a scene with their elements counted. COST: linear in the surfaces.
std::vector<CountedFace> counted_faces_2(const Scene2& scene, Granularity granularity);

// Samples pairs of elements, and asks in doubles whether some line between two points of them, one of some that are
// drawn, meets no edge. Overlaps and solids are not looked at: it may be wrong either way.
// REQUIRES as sampled_pairs. COST: a quarter of a second at most, however many elements there will be.
SampledPairs estimated_pairs_2(const Scene2& scene, std::span<const CountedFace> faces);

}  // namespace hottel

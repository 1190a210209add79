// Which surfaces of a scene a file says as polylines.
#pragma once

#include <cstddef>

#include "geometry/plane/scene/scene.h"

namespace hottel {

// Returns the index after the run of surfaces that begins at `first` and is one polyline; `first` itself if it is none.
// A run of one group is a polyline of the group's name iff
//
//   (1) its surfaces are called NAME[0], NAME[1], ... in their order, and NAME may be a name
//   (2) each begins where the one before ends
//   (3) material, back, elements and what they lie on are the same for all
//
// The run is all of the group that stands together. REQUIRES: an index of a surface. COST: linear in the run.
std::size_t end_of_polyline(const Scene2& scene, std::size_t first);

// Returns the index of the first surface from which on all are polylines, each with a group of its own: what stands
// before it can be written as edges only. COST: linear.
std::size_t first_of_polylines(const Scene2& scene);

}  // namespace hottel

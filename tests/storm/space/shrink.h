// The least of a scene of space that still fails.
#pragma once

#include <functional>

#include "tests/storm/space/lattice_scene.h"

namespace hottel::storm {

// Leaves out polygons, all but 0 and 1, and corners of those that have more than three; then moves the scene, a corner,
// or all corners that are in one point, nearer to the origin along the axes, in whole steps where they are whole; and
// begins anew, as long as what is left is valid and still fails. REQUIRES fails(polygons).
Polygons3 shrunk_3(Polygons3 polygons, const std::function<bool(const Polygons3&)>& fails);

}  // namespace hottel::storm

// The stretches that bound the lines between two patches. Internal to geometry/space/exchange.
#pragma once

#include <vector>

#include "geometry/space/between/pair_occluders.h"
#include "geometry/space/pieces/stretch_map.h"
#include "geometry/space/stretches/surface_stretches.h"

namespace hottel {

// Returns the stretches along which the measure of a pair is integrated: the edges of both patches, cut where surfaces
// that stand on them begin and end; the stretches on which surfaces stand on a patch, or pierce it; and the outlines of
// surfaces between. Outlines are cut short, in doubles and outward, to the hull of both patches.
//
//   (1) each is there once; order depends on the pair alone
//   (2) those along which nothing is seen, by where they lie, may be left out
std::vector<PairStretch3> pair_stretches(const PairOccluders3& setting, const SurfaceStretches3& stretches,
                                         const Patch3& i, const Patch3& j);

}  // namespace hottel

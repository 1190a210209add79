// What the lights of a scene in space shine on first, and how much of their power arrives there.
#pragma once

#include <vector>

#include "geometry/element.h"
#include "geometry/space/exchange/prepared_scene.h"
#include "geometry/space/visibility/beam.h"
#include "solver/radiosity/direct_light.h"

namespace hottel {

// The beam of a light as it stands.
Beam3 beam_of(const Light& light, const LightPlace3& place);

// Returns the shares of each light as it stands: Phi_i / P. The elements are those of a matrix of that granularity.
//
//   (1) what is seen from the light is its exact map; shares are proven bounds (beam_shares)
//   (2) a face in whose plane the light lies, and one that the beam only touches, gets 0
//   (3) a light in a solid gives nothing to anybody (LightShares::solid)
//
// REQUIRES a scene that validate() takes: no light lies on a polygon. COST: a map from each light, and balls for each
// piece that it sees. Nothing without lights.
std::vector<LightShares> light_shares(const PreparedScene3& prepared, Granularity granularity);

}  // namespace hottel

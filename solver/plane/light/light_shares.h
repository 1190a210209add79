// What the lights of a scene in the plane shine on first, and how much of their power arrives there.
#pragma once

#include <vector>

#include "geometry/element.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "solver/radiosity/direct_light.h"

namespace hottel {

// Returns the shares of each light as it stands: Phi_i / P.
//
//   (1) what is seen from the light is exact, and so are the corners between which a face is seen; a share is the
//       integral of cos^n over the angles that lie in the beam, within proven bounds of a few ulps
//   (2) a face in whose line the light lies, and one that the beam only touches, gets exactly 0
//   (3) a light in a solid gives nothing to anybody (LightShares::solid)
//   (4) of a sun they are what it lights across its rays (SunView2): exact lengths, a rational over the length of its
//       direction, within two ulps. An edge along which the rays run gets exactly 0
//
// The elements are those of a matrix of that granularity. REQUIRES a scene that validate() takes: no light lies on an
// edge. COST: a view from each light, and some 10 µs for each piece seen. Nothing without lights.
std::vector<LightShares> light_shares(const PreparedScene2& prepared, Granularity granularity);

}  // namespace hottel

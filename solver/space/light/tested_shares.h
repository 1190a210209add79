// The shares of lights in space by tests of a few points of each element.
#pragma once

#include <vector>

#include "geometry/element.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "solver/radiosity/direct_light.h"
#include "solver/radiosity/radiosity_options.h"

namespace hottel {

// Returns the shares of each light as it stands, by a test; those of kExact are light_shares(prepared, granularity).
//
//   (1) which points are tested, and what an element that passes gets: LightTest; vertices are all corners. A point is
//       seen as VisibilityFinder3 says
//   (2) decided exactly; the share itself is off by a few ulps, and n ulps more for a falloff n. It is no bound
//   (3) an element of several patches, where it is not convex or covers leave them, gets what each of them, as an
//       element by itself, would get
//   (4) the sky has no centroid: its share is exact. So what the shares lack of 1, or have too much, is what the tests
//       of the elements are off
//   (5) a light in a solid gives nothing to anybody
//   (6) of a sun an element that passes gets its area times the cosine; LightShares::whole stays exact
//
// REQUIRES a scene that validate() takes: no light lies on a polygon. Throws RequestError, naming file, light and
// element, where a share is beyond the range of doubles.
// COST: two maps from each light, that of the exact shares of faces for the sky, and some 20 µs for each point.
std::vector<LightShares> light_shares(const PreparedScene3& prepared, Granularity granularity, LightTest test);

}  // namespace hottel

// What a point in space sees, as JSON and as text for people.
#pragma once

#include <string>

#include "geometry/space/visibility/point_bounds.h"
#include "geometry/space/visibility/visibility_map.h"
#include "io/results/visibility_answer.h"

namespace hottel {

struct Scene3;
class Solids3;

// The map of a point: of each face that is seen its solid angle and its pieces, as unit vectors and as points on the
// face; of the sky its solid angle. From a point of a face, where look has a normal, also the view factors. The text
// has no pieces. what: how the point was called, for the text: "(1, 2, 3)", "'floor' at (1, 2, 3)".
//
//   (1) fractions are of the full sphere; solid angles [sr] are 4 pi times that
//   (2) faces are in the order of the scene
//   (3) of a point on the border of solids, what leads into these is told by their names
//   (4) with bounds, which are of the same shares, those of factors and fractions stand beside them, and numbers are
//       within: a sky of which rounding left something is 0 where it may be
VisibilityAnswer map_answer(const Scene3& scene, const Solids3& solids, const Look3& look, const VisibilityMap3& map,
                            const std::string& what, const PointBounds3* bounds = nullptr);

// The same of a point in a solid: the name of its group; no face is seen, nor the sky, and irradiance is null.
VisibilityAnswer answer_in_solid_3(const Look3& look, const std::string& solid, const std::string& what);

}  // namespace hottel

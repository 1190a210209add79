// Polygons divided where the light of lamps ends.
#pragma once

#include <memory>
#include <vector>

#include "geometry/space/prepared/prepared_scene.h"
#include "solver/refinement.h"

namespace hottel {

// Returns the trees under the elements of the scene that are as deep as asked for, as its lights stand.
//
//   (1) which part of an element a light reaches, of all of it that belongs to the face and is not covered, is decided
//       exactly: nothing, a part or all of its area. A part: it is divided, until it has the depth levels.at_borders
//   (2) exact are the fragments of the map of each light, whose cones are cut with that of the element, and on which
//       side of the beam each lies (BeamPower3)
//   (3) an element in whose plane or behind which a light lies, or that a beam or light only touches, is dark
//   (4) trees are a function of the shape of the scene and of its lights; they are empty where nothing is divided
//
// The trees of the scene are not looked at. COST: a map from each light; for each node next to a border some
// microseconds for each fragment of a map that may be in it.
std::vector<SurfaceTrees> refined_trees(const PreparedScene3& prepared, const RefinementLevels& levels);

}  // namespace hottel

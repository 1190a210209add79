// Edges divided where the light of lamps ends.
#pragma once

#include <vector>

#include "geometry/plane/prepared/prepared_scene.h"
#include "solver/refinement.h"

namespace hottel {

// Returns the trees under the elements of the scene that are as deep as asked for, as its lights stand.
//
//   (1) which part of an element a light reaches, of all of it that belongs to the face, is decided exactly: nothing, a
//       part or all of its length. A part: it is divided, until it has the depth levels.at_borders
//   (2) shadows end in rational points; where a beam ends on an edge is told by Beam2
//   (3) an element in whose line a light lies, or that a beam or light only touches, is dark
//   (4) trees are a function of the shape of the scene and of its lights; they are empty where nothing is divided
//
// The trees of the scene are not looked at. COST: a view from each light, and some microseconds for each node looked
// at.
std::vector<SurfaceTrees> refined_trees(const PreparedScene2& prepared, const RefinementLevels& levels);

}  // namespace hottel

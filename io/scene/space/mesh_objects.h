// Groups that close together, as objects of OBJ files.
#pragma once

#include <string>
#include <vector>

#include "geometry/space/scene/scene.h"

namespace hottel {

// Returns for each group of a scene the object of an OBJ file that it stands in; none where no groups have to stand
// together.
//
//   (1) the groups of a closed mesh stand in one object with those of the patches on its fronts, by way of others too;
//       so do the groups of a body. It is called as the body or the mesh
//   (2) each other group is an object of its own
//   (3) objects that differ have names that differ
//
// COST: that of Solids3, where there are patches.
std::vector<std::string> mesh_objects(const Scene3& scene);

}  // namespace hottel

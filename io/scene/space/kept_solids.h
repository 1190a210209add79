// What becomes of solids in files that say less than a scene.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "geometry/space/scene/scene.h"

namespace hottel {

// Returns sentences without a full stop about what is solid in a scene and hollow in the scene that its file is read
// as, and the other way round; none where all is kept. They name groups and bodies.
//
//   (1) a solid is kept where the group of its name is solid too, or where the file has one group and that is
//   (2) none where one of the two scenes is refused (Solids3, read)
//
// `name_in_file`: what the file calls a group. `read` is asked only where something is to be told.
// COST: that of Solids3 for both.
std::vector<std::string> notes_on_solids(const Scene3& scene, const std::function<Scene3()>& read,
                                         const std::function<std::string(const std::string&)>& name_in_file);

}  // namespace hottel

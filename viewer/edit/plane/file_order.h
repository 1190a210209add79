// A scene as its file will give it back.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/plane/scene/scene.h"

namespace hottel {

// Returns the scene that reading its saved text gives (write_scene_2, parse_scene_2), without writing a text: names,
// groups and the order of surfaces included. File and lines stay those of `scene`.
//
//   (1) surfaces keep their names, materials and places in the list
//   (2) those before first_of_polylines(scene) are groups of their own, each of its own name and with what its group
//       said of its backs; the others are polylines
//   (3) as_read(as_read(scene)) is as_read(scene)
//   (4) where reading would refuse the scene, because an edge has length zero or two things have one name, it is what
//       would be read if that were allowed
//
// REQUIRES: what write_scene_2 requires, but for (4). COST: linear; a copy of the scene.
Scene2 as_read(const Scene2& scene);

// A scene whose surfaces may have changed places.
struct FileOrder2 {
  Scene2 scene;
  std::vector<std::uint32_t> place;  // by surface as it was: where it stands now
};

// Puts surfaces into the order in which a file keeps them: edges before polylines.
//
//   (1) as_read(result) is the result
//   (2) a group that is a polyline as a whole (end_of_polyline) stays one; the surfaces of any other group are edges,
//       groups of their own, which keep their names ("room[3]") and what the group said of its backs
//   (3) edges keep their order, and so do polylines: each goes on winning or losing overlaps as before, unless an edge
//       comes to stand before a polyline
//   (4) an edge that has the name of a polyline gets another one, "room[3] 2"; nothing else is called anew
//
// REQUIRES: the names of surfaces and those of polylines are allowed and unique. COST: linear; nothing is moved where
// all is in order.
FileOrder2 in_file_order(Scene2 scene);

}  // namespace hottel

// Scenes in space that tests edit.
#pragma once

#include "io/scene/scene_json.h"

namespace hottel::testing_edits {

// A room of 4 x 4 x 3 with a solid box on its floor, a tent of triangles, a wall with a hole, a window on a wall and a
// picture on the window, and a bulb.
inline constexpr const char* kFurnished = R"({"hottel": 1, "dimension": 3,
  "materials": {"white": {"reflectivity": 0.5}, "red": {"reflectivity": [0.6, 0.1, 0.1]}, "lamp": {"emission": 2}},
  "polygons": [
    {"name": "floor", "points": [[0,0,0],[4,0,0],[4,4,0],[0,4,0]], "material": "white", "elements": 2},
    {"name": "ceiling", "points": [[0,0,3],[0,4,3],[4,4,3],[4,0,3]], "material": "white"},
    {"name": "front", "points": [[0,0,0],[0,0,3],[4,0,3],[4,0,0]], "material": "white"},
    {"name": "rear", "points": [[0,4,0],[4,4,0],[4,4,3],[0,4,3]], "material": "red"},
    {"name": "left", "points": [[0,0,0],[0,4,0],[0,4,3],[0,0,3]], "material": "white"},
    {"name": "right", "points": [[4,0,0],[4,0,3],[4,4,3],[4,4,0]], "material": "white"},
    {"name": "window", "points": [[1,4,1],[3,4,1],[3,4,2],[1,4,2]], "material": "lamp", "on": "rear"},
    {"name": "picture", "points": [[2,4,1.2],[2.5,4,1.2],[2.5,4,1.7],[2,4,1.7]], "material": "red", "on": "window"},
    {"name": "box.bottom", "group": "box", "points": [[1,1,0],[1,2,0],[2,2,0],[2,1,0]], "material": "white"},
    {"name": "box.top", "group": "box", "points": [[1,1,1],[2,1,1],[2,2,1],[1,2,1]], "material": "white"},
    {"name": "box.a", "group": "box", "points": [[1,1,0],[2,1,0],[2,1,1],[1,1,1]], "material": "white"},
    {"name": "box.b", "group": "box", "points": [[2,1,0],[2,2,0],[2,2,1],[2,1,1]], "material": "white"},
    {"name": "box.c", "group": "box", "points": [[2,2,0],[1,2,0],[1,2,1],[2,2,1]], "material": "white"},
    {"name": "box.d", "group": "box", "points": [[1,2,0],[1,1,0],[1,1,1],[1,2,1]], "material": "white"},
    {"name": "tent[0]", "group": "tent", "points": [[3,3,0.5],[3.5,3,0.5],[3.2,3.2,1]], "material": "red", "back": "white"},
    {"name": "tent[1]", "group": "tent", "points": [[3.5,3,0.5],[3.4,3.5,0.5],[3.2,3.2,1]], "material": "red", "back": "white"},
    {"name": "frame", "points": [[0.5,3,0.5],[1.5,3,0.5],[1.5,3,1.5],[0.5,3,1.5]],
     "holes": [[[0.8,3,0.8],[1.2,3,0.8],[1.2,3,1.2]]], "material": "red", "back": "red"}],
  "lights": [{"type": "point", "name": "bulb", "position": [2, 0.5, 2.5], "power": 3}],
  "camera": {"eye": [2, 0.25, 1.5], "target": [2, 4, 1.25], "field_of_view": 80, "pixels": [800, 600]}})";

inline Scene3 furnished() { return parse_scene_3(kFurnished, "furnished.json"); }

}  // namespace hottel::testing_edits

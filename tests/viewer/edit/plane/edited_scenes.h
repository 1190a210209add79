// Scenes to edit, and how they are compared.
#pragma once

#include <string>

#include "geometry/plane/scene/scene_builder.h"
#include "io/scene/scene_json.h"

namespace hottel {

// Where two scenes differ, lines and files aside; empty where they do not.
inline std::string difference(const Scene2& a, const Scene2& b) {
  if (a.surfaces.size() != b.surfaces.size()) return "number of surfaces";
  for (std::size_t s = 0; s < a.surfaces.size(); ++s) {
    Surface first = a.surfaces[s], second = b.surfaces[s];
    first.line = second.line = 0;
    if (first.on.has_value() != second.on.has_value() ||
        (first.on && !(a.bases.at(*first.on) == b.bases.at(*second.on))))
      return "what " + first.name + " lies on";
    if (!(first == second)) return "surface " + std::to_string(s) + ": " + first.name + ", " + second.name;
    if (!(a.edges[s] == b.edges[s])) return "edge " + first.name;
  }
  if (a.groups != b.groups) return "groups";
  if (a.bases != b.bases) return "bases";
  if (a.materials.size() != b.materials.size()) return "number of materials";
  for (std::size_t m = 0; m < a.materials.size(); ++m) {
    const Material &first = a.materials[m], &second = b.materials[m];
    if (first.name != second.name || !(first == second)) return "material " + first.name;
    if (first.reflectivity.is_scalar != second.reflectivity.is_scalar ||
        first.emission.is_scalar != second.emission.is_scalar)
      return "channels of material " + first.name;
  }
  if (!(a.sky_emission == b.sky_emission) || a.grids != b.grids || a.closed != b.closed || a.about != b.about)
    return "sky, grid, closed or about";
  return a.expect.size() != b.expect.size() ? "expectations" : "";
}

// What is read after the scene was saved.
inline Scene2 saved_and_read(const Scene2& scene) { return parse_scene_2(write_scene_2(scene), scene.file); }

// An edge "screen" (0), then polylines: the closed "room" (1..4), clockwise, the open "step" (5, 6), solid, with two
// elements, and the closed "table" (7..10), counter-clockwise.
inline Scene2 small_room() {
  SceneBuilder2 builder;
  builder.add_material("white", {.reflectivity = "0.7"}).add_material("lamp", {.emission = {3, 2, 1}});
  builder.add_edge("screen", {1, 1}, {1, 2}, "white", {.back = "white"});
  builder.add_polyline("room", {{0, 0}, {0, 3}, {4, 3}, {4, 0}}, "white", {.closed = true});
  builder.add_polyline("step", {{4, "1/2"}, {3, "1/2"}, {3, 0}}, "lamp", {.elements = 2, .behind = Behind::kSolid});
  builder.add_polyline("table", {{2, 1}, {3, 1}, {3, 2}, {2, 2}}, "white", {.closed = true});
  builder.set_closed().set_grid({0, 0}, {4, 3}, 8, 6);
  return builder.build();
}

// The same room with patches: a "window" (1) on the room's left wall and a "pane" (2) on that, a "door" (3) on a wall
// by its own name, and a "label" (0) on the table.
inline Scene2 patched_room() {
  SceneBuilder2 builder;
  builder.add_material("white", {.reflectivity = "0.7"}).add_material("lamp", {.emission = {3, 2, 1}});
  builder.add_edge("label", {3, "5/4"}, {3, "7/4"}, "lamp", {.on = "table"});
  builder.add_edge("window", {0, 1}, {0, 2}, "lamp", {.on = "room"});
  builder.add_edge("pane", {0, "4/3"}, {0, "5/3"}, "white", {.on = "window"});
  builder.add_edge("door", {3, 0}, {2, 0}, "lamp", {.on = "room[3]"});
  builder.add_polyline("room", {{0, 0}, {0, 3}, {4, 3}, {4, 0}}, "white", {.closed = true});
  builder.add_polyline("table", {{2, 1}, {3, 1}, {3, 2}, {2, 2}}, "white", {.closed = true});
  return builder.build();
}

inline std::string showcase(const std::string& name) {
  return std::string(HOTTEL_SOURCE_DIR) + "/scenes/showcase/" + name + ".json";
}

}  // namespace hottel

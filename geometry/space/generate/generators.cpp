#include "geometry/space/generate/generators.h"

#include <string>

#include "geometry/space/generate/generate_kinds.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

using Generate = Scene3 (*)(const GeneratorRequest3&);

struct Entry {
  GeneratorKind3 kind;
  Generate generate;
};

const std::vector<Entry>& entries() {
  static const std::vector<Entry> kEntries = {
      {{"room-boxes", "a closed room with boxes that stand on its floor, uncut below them, along the axes",
        "N boxes: 6 + 6 N polygons; 6 + 5 N without bottoms", 1, 8, true},
       generate_room_boxes_3},
      {{"room-stacked", "a closed room with towers of boxes, flush with those below, set back, or overhanging",
        "N boxes: 6 + 6 N polygons; 6 + 5 N without bottoms", 1, 8, true},
       generate_room_stacked_3},
      {{"room-touching", "a closed room with boxes that touch each other and its walls: in faces, edges and corners",
        "N boxes: 6 + 6 N polygons", 1, 8, false},
       generate_room_touching_3},
      {{"room-floating", "a closed room with boxes along the axes that touch nothing", "N boxes: 6 + 6 N polygons", 1,
        8, false},
       generate_room_floating_3},
      {{"room-turned", "a closed room with boxes that touch nothing, turned by rational rotations: exactly plane",
        "N boxes: 6 + 6 N polygons", 1, 8, false},
       generate_room_turned_3},
      {{"room-piercing", "a closed room with turned boxes that pierce each other, two to five at a place",
        "N boxes: 6 + 6 N polygons", 2, 8, false},
       generate_room_piercing_3},
      {{"street-blocks", "buildings along streets, on an uncut ground under a sky that emits",
        "N buildings: 1 + 6 N polygons; 1 + 5 N without bottoms", 1, 30, true},
       generate_street_blocks_3},
      {{"town",
        "a town: a building on each lot, 25 lots in a row, on a ground of 20 x 20 elements under a sky that emits",
        "N buildings: 1 + 6 N polygons; 1 + 5 N without bottoms; each face of a building has 2 x 2 elements", 1, 30,
        true},
       generate_town_3},
      {{"terrain", "hills of triangles with buildings whose feet are in the ground, under a sky that emits",
        "at most N polygons, fewer than 6 less; about a tenth of them are of buildings", 200, 1000, false},
       generate_terrain_3},
      {{"nested-cubes", "cubes in each other: a room, in it a solid cube, in that a room, and so on",
        "N cubes: 6 N polygons", 1, 8, false},
       generate_nested_cubes_3},
      {{"triangle-soup", "a closed room with random triangles that pierce each other; no two in one plane",
        "exactly N polygons, 6 of them the walls", 7, 100, false},
       generate_triangle_soup_3},
      {{"furnished-room", "a closed room, all of triangles: tables with chairs, shelves, lamps",
        "12 + 336 p polygons for p places, the largest such number that is at most N", 348, 348, true},
       generate_furnished_room_3},
      {{"flat",
        "a closed flat, all of triangles: furnished rooms side by side, with walls between them that have doorways",
        "370 r - 20 polygons for r rooms, the largest such number that is at most N", 350, 1090, true},
       generate_flat_3},
      {{"lattice-boxes", "boxes with corners on a lattice in a closed room: coplanar overlaps, contacts, equal boxes",
        "N boxes: 6 + 6 N polygons", 1, 12, false},
       generate_lattice_boxes_3},
  };
  return kEntries;
}

}  // namespace

const std::vector<GeneratorKind3>& generator_kinds_3() {
  static const std::vector<GeneratorKind3> kKinds = [] {
    std::vector<GeneratorKind3> kinds;
    for (const Entry& entry : entries()) kinds.push_back(entry.kind);
    return kinds;
  }();
  return kKinds;
}

Scene3 generate_3(const GeneratorRequest3& request) {
  std::string names, standing;
  for (const Entry& entry : entries()) {
    names += (names.empty() ? "" : ", ") + entry.kind.name;
    if (entry.kind.stands) standing += (standing.empty() ? "" : ", ") + entry.kind.name;
  }
  for (const Entry& entry : entries()) {
    if (entry.kind.name != request.kind) continue;
    if (request.n < entry.kind.min_n || request.n > kMaxGeneratedBodies)
      throw UsageError("--n must be between " + std::to_string(entry.kind.min_n) + " and " +
                       std::to_string(kMaxGeneratedBodies) + " for " + request.kind);
    if (!request.has_bottoms && !entry.kind.stands)
      throw UsageError("--no-bottoms is an option of kinds in which bodies stand on something: " + standing);
    return entry.generate(request);
  }
  throw UsageError("unknown kind of scene: " + request.kind + " (there are " + names + ")");
}

}  // namespace hottel

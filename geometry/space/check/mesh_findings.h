// What is worth telling about closed meshes, and rooms made of single polygons.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/space/check/edge_stretches.h"
#include "geometry/space/check/finding.h"

namespace hottel {

// What the edges of a scene show about its meshes.
struct Meshes3 {
  // A hole: joined edges, each of one polygon of the group alone, that lie on nothing.
  struct Hole {
    std::uint32_t group = 0;  // of a body the first
    std::string name;         // of the group, or the body
    std::vector<EdgeStretch3> edges;
  };
  // Where light leaves: "an edge of 'a' from (0, 0, 0) to (1, 0, 0) lies on nothing".
  struct Gap {
    Point3 at;
    double width = 0;
    std::string text{};
  };
  std::vector<Hole> holes;
  std::vector<EdgeStretch3> crowded;     // edges of a group that more than two of its polygons have
  std::vector<EdgeStretch3> opposed;     // edges of a group whose two polygons have their fronts on different sides
  std::vector<std::uint32_t> reversed;   // polygons that have all of their edges in common with others, each with one,
                                         // and the fronts of all of those are on the other side
  std::vector<char> is_closed, is_room;  // by group: each edge is used as often in one direction as in the other; and
                                         // its fronts look inward
  std::vector<EdgeStretch3> bare;        // edges of one polygon of the scene that lie on nothing else
  std::optional<Gap> leak;               // where light leaks out; find_meshes leaves it empty
};

// Looks at the edges of a scene, T-junctions and all. Exact.
//
//   (1) holes are those of groups of three or more polygons most of whose edges two of them share: an open box or a
//       sheet that stands free has them, a box without a bottom on a floor has none
//   (2) an edge lies on something when polygons of others cover all of it
//   (3) reversing all polygons that are `reversed` leaves none
//   (4) groups of one body of which none is closed are looked at as one
//
// COST: O(n log n), and exact arithmetic for edges of one polygon and what their boxes meet.
Meshes3 find_meshes(const Scene3& scene);

// Kinds: open-mesh, upside-down, opposed-fronts (warnings), crowded-edge (note).
Findings3 mesh_findings(const Scene3& scene, const Meshes3& meshes);

}  // namespace hottel

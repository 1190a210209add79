// Closed parts of meshes that have nothing in them.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/space/check/finding.h"
#include "geometry/space/scene/scene.h"

namespace hottel {

// A closed part of a mesh: polygons of one group that hang together by their edges.
struct Shell3 {
  std::uint32_t group = 0;
  std::vector<std::uint32_t> surfaces;  // ascending
  bool may_be_body = false;
};

// Returns the closed parts of meshes, whichever way their fronts look: polygons of one group that hang together by
// their edges, each edge used as often in one direction as in the other. Each part has four polygons or more,
// ascending. COST: n log n for n edges.
std::vector<std::vector<std::uint32_t>> closed_parts(const Scene3& scene);

// Returns the parts of meshes that are inside out if they are meant as bodies: closed, with their fronts inward, and
// empty.
//
//   (1) nothing is inside such a part: no other surface, light, camera or grid; nor is the part a hollow in a body
//   (2) parts whose backs have a material, and those that say "behind": "open", are rooms; so is what is all of a scene
//       that promises to be closed
//   (3) may_be_body: the scene does not promise to be closed, and its sky sends something or there are surfaces outside
//       the part. Else the part may be a furnace
//
// Exact. COST: n log n for n edges of groups of four polygons or more; for each part with its fronts inward that of a
// Solids3 of it, and a winding number for each corner in its box.
std::vector<Shell3> inside_out_shells(const Scene3& scene);

// Adds a finding for each, a warning (inside-out). A finding that is there already becomes a warning where the part may
// be a body.
void tell_inside_out(const Scene3& scene, const std::vector<Shell3>& shells, Findings3& findings);

}  // namespace hottel

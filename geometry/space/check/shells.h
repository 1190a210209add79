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
// their edges, each of which is run through as often one way as the other. Each ascending; of four polygons at least.
// COST: n log n for n edges.
std::vector<std::vector<std::uint32_t>> closed_parts(const Scene3& scene);

// Returns the parts of meshes that are inside out, if bodies are meant: closed, with their fronts inward, and empty.
//
//   (1) nothing is in one: no other surface, light, camera or grid; nor is it in a body itself, as a hollow is
//   (2) parts whose backs have a material, and those that say "behind": "open", are rooms; so is what is all of a scene
//       that promises to be closed
//   (3) may_be_body: the scene does not promise that, and its sky sends something, or there are surfaces outside. Else
//       it may be a furnace
//
// Exact. COST: n log n for n edges of groups of four polygons or more; for each part with its fronts inward that of a
// Solids3 of it, and a winding number for each corner in its box.
std::vector<Shell3> inside_out_shells(const Scene3& scene);

// Tells of them: a warning each (inside-out). What is told of one already becomes a warning where it may be a body.
void tell_inside_out(const Scene3& scene, const std::vector<Shell3>& shells, Findings3& findings);

}  // namespace hottel

// How the sides of polygons lie along each other.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/space/scene/polygon_places.h"
#include "geometry/space/scene/scene.h"

namespace hottel {

// A polygon that has a stretch in its outline.
struct EdgeUse3 {
  std::uint32_t surface = 0;
  bool is_reversed = false;  // its outline goes from `to` to `from`
  friend bool operator==(const EdgeUse3&, const EdgeUse3&) = default;
};

// A stretch of a line along which the same sides lie.
struct EdgeStretch3 {
  Point3 from, to;
  std::vector<EdgeUse3> uses;  // by surface
};

// Returns the sides of all polygons of a scene, cut where a side of the same line begins or ends.
//
//   (1) stretches do not overlap; together they are the sides. A closed surface is one in which each stretch is used as
//       often in one direction as in the other, T-junctions or none
//   (2) ordered by their first surface, then along its outline
//
// Exact. COST: O(n log n) for n sides and stretches.
std::vector<EdgeStretch3> find_edge_stretches(const std::vector<Polygon3>& polygons);

// The same of a scene without the sides of its patches, which bound nothing.
std::vector<EdgeStretch3> find_edge_stretches(const Scene3& scene);

// Returns whether all of a segment lies in polygons of a list (with their borders), each as a whole or in parts:
// through none of its points one gets from one side of it to another along them.
bool is_covered(const Side3& segment, const std::vector<Polygon3>& polygons, const std::vector<std::uint32_t>& list);

}  // namespace hottel

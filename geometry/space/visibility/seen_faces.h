// Which faces of a scene a point sees, where its polygons are several pieces.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/space/arrangement/arrangement.h"
#include "geometry/space/visibility/visibility_map.h"

namespace hottel {

// Returns a map that was made of the pieces of an arrangement, its faces those of the scene: the owners of the sides
// of pieces. Fragments are by these faces, and a face has one share.
VisibilityMap3 with_owners(VisibilityMap3 map, const Arrangement3& arrangement);

// The solid meshes on whose faces a point is, edges and corners included.
std::vector<std::uint32_t> solids_at(const Solids3& solids, const Point3& point);

// Returns a map in all directions, from a point of the border of solids, without what is seen through these: sides of
// pieces that look into a solid, and of those that do so in part that part. As with_owners otherwise.
//
//   (1) the fractions of shares, solids and sky sum to 1
// REQUIRES that the look has no normal, and meshes = solids_at(eye), not empty.
VisibilityMap3 outside_solids(VisibilityMap3 map, const Arrangement3& arrangement, const Point3& eye,
                              const std::vector<std::uint32_t>& meshes);

// Returns what is seen of the scene from a point, in all directions: with_owners, or outside_solids where the point is
// on the border of solids. occluders: the pieces of the arrangement. REQUIRES a point that no solid is around.
VisibilityMap3 faces_seen_from(const Point3& eye, const Occluders3& occluders, const Arrangement3& arrangement);
// The same of a map of the point in all directions, as map_from() has it.
VisibilityMap3 faces_seen_from(const Point3& eye, VisibilityMap3 map, const Arrangement3& arrangement);

}  // namespace hottel

// The patches that a face, or a part of it, is made of.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "geometry/face.h"
#include "geometry/space/arrangement/arrangement.h"
#include "geometry/space/arrangement/occluders.h"
#include "geometry/space/arrangement/patch.h"

namespace hottel {

// A patch, and whether it is on the back of its piece: not of its surface, where two polygons share a place.
struct SidePatch3 {
  Patch3 patch;
  bool is_back;
};

// Patches of one face.
//
//   (1) `patches` are whole where a solid covers some of them: what is covered exchanges nothing with what is free. So
//       S of two faces is that of the patches of one and of what is free of the other. A patch that is covered wholly
//       is left out; of one that is covered by more than 15/16, what is free are the patches: S is small against what
//       the whole would exchange, and digits would be lost
//   (2) `free` are those without what is covered, where is_free is false; else they are the same, and it is empty
//   (3) each lies within one piece, its front to the side of the face
struct FacePatches3 {
  std::vector<SidePatch3> patches, free;
  bool is_free = true;

  const std::vector<SidePatch3>& uncovered() const { return is_free ? patches : free; }
};

// Returns the patches of a face, or those of a part of it: a convex polygon with corners in scene coordinates, its
// front as that of the surface.
//
// REQUIRES: the occluders are the pieces of the arrangement.
FacePatches3 face_patches(const Arrangement3& arrangement, const Occluders3& occluders, const Face& face,
                          const std::vector<Point3>* part = nullptr);

// Returns a convex polygon of a piece as a patch; its front is that of the piece, and is_back turns it round.
Patch3 patch_of(const Occluders3& occluders, std::uint32_t piece, const std::vector<Point3>& corners, bool is_back);

// Returns points of the scene in integer form times their least common denominator, and that: 1 where all are vertices.
std::pair<std::vector<IntegerVector>, Integer> integer_points(const Vertices3& vertices,
                                                              std::span<const Point3> points);

// Returns the corners of a patch in scene coordinates, exactly.
std::vector<Point3> corners_of(const Vertices3& vertices, const Patch3& patch);

}  // namespace hottel

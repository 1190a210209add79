// What pairs take of a patch, made once. Internal to geometry/space.
#pragma once

#include <vector>

#include "geometry/space/arrangement/occluders.h"
#include "geometry/space/arrangement/patch.h"
#include "geometry/space/arrangement/surface_boxes.h"

namespace hottel {

// A patch with everything that PairGeometry3 and PairOccluders3 need of it and that depends on no other patch.
//
//   (1) pairs of known patches are the same, bit for bit, as those of the patches themselves
//
// REQUIRES: patch and occluders outlive it. COST: some microseconds; some 100 bytes a corner.
struct KnownPatch3 {
  const Patch3* patch;
  long spare = 0;                          // by how many bits the weight is longer than a double
  long bits = 0;                           // of the largest coordinate, without those
  std::vector<VertexId3> vertices;         // of its surface, at the corners; none where there is none
  std::vector<BoundedVector> approximate;  // the corners, in doubles of whole numbers
  double weight = 0;                       // of the corners, times 2^-spare
  IntegerVector normal;                    // of its front, coprime; zero where it is far
  BoundedVector rounded_normal;
  int turn = 0;  // +1 where its front is that of its surface, -1 where it is the back; 0 of the sky
  Box3 box;      // around nothing where it is far

  KnownPatch3(const Occluders3& occluders, const Patch3& its);
};

}  // namespace hottel

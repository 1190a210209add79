// What a ray meets first.
#pragma once

#include <vector>

#include "geometry/plane/arrangement/arrangement.h"

namespace hottel {

// A ray that leaves one side of a piece: from the point a + s (b - a) of the piece a -> b, in the direction (dx, dy) of
// the scene's axes. It is exactly the ray that these doubles say.
// REQUIRES 0 < s < 1, and a direction that points away from that side.
struct PieceRay2 {
  PieceSideId from{0};
  double s = 0.5;
  double dx = 0, dy = 0;
};

// Follows rays through the triangulation.
//
//   (1) exact: the side that is met first, or kSky
//   (2) a ray through a vertex is moved to its left, parallel, by an infinitesimal amount: no ray slips through where
//       two pieces meet, and it meets what its neighbours on the left meet
// COST: about 10 ns for each triangle on the way.
class FirstHit2 {
 public:
  // REQUIRES that the arrangement outlives this.
  explicit FirstHit2(const Arrangement2& arrangement);

  // Returns the side that the ray meets first, or kSky. It may be a side that looks into a solid.
  PieceSideId operator()(const PieceRay2& ray) const;

 private:
  const Arrangement2& arrangement_;
  std::vector<Beyond2> gate_;  // by side: the triangle before it, entered through it; the sky outside of the hull
};

}  // namespace hottel

// Parts of a stretch along which what is seen is proven to be bounded by the same arcs. Internal to geometry/space.
#pragma once

#include <vector>

#include "geometry/space/moving/moving_planes.h"
#include "geometry/space/pieces/arc_sum.h"
#include "geometry/space/pieces/stretch_piece.h"

namespace hottel {

// A part of a stretch along which all signs that what is seen rests on are proven to keep, but for gaps.
//
//   (1) from piece.low to piece.high what is seen is bounded by the arcs of piece.signature, but for gaps of no more
//       than `gaps` together, in which it may be anything
//   (2) parts are in order, and do not overlap. What is between two of them, and before the first and after the last
//       one, may be anything too
struct SurePart3 {
  StretchPiece3 piece;
  double gaps = 0;
};

// What is proven of a stretch. The signatures of its pieces are packed.
struct SureStretch3 {
  bool sees_nothing = false;  // whatever t
  std::vector<SurePart3> parts;
};

// A piece with vectors that are zero nowhere (MovingPlanes3::whole_normal).
template <class Real>
struct WholePiece3 {
  std::vector<MovingPlanes3::WholeVector<Real>> planes, corners;
  std::vector<SeenArc3> arcs;
};

}  // namespace hottel

// The corners of the region that a point sees, before they have coordinates.
#pragma once

#include <vector>

#include "geometry/plane/arrangement/arrangement.h"
#include "geometry/plane/visibility/view.h"

namespace hottel {

// One corner of the region that an eye sees, and what is seen between it and the next one.
//
//   kVertex  the vertex itself
//   kBehind  where the ray from the eye through the vertex meets the piece of `on`
//   kEye     the eye, where a solid begins or ends there in a corner
struct ViewCorner2 {
  enum class Kind : unsigned char { kVertex, kBehind, kEye };
  Kind kind = Kind::kVertex;
  VertexId vertex{0};
  PieceSideId on = kNoPiece;     // kBehind
  PieceSideId after = kNoPiece;  // kSky where the region is open; kNoPiece along a ray from the eye, or an edge at it
};

// Fills the list with the corners, counter-clockwise; what it held before is lost.
//
//   (1) they are those of VisibilityPolygon2::corners(), in that order: each point once, none from within a solid
//   (2) `after` is a free side, kSky or kNoPiece: never one that is covered
//   (3) of corners with `after` a side, both this and the next lie on the piece of that side
//
// REQUIRES the view from the eye. COST: a few ns a corner; one orientation where pieces meet behind a vertex.
void view_corners(const Arrangement2& arrangement, const Eye2& eye, const View2& view,
                  std::vector<ViewCorner2>& corners);

}  // namespace hottel

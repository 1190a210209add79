// The lines through two vertices along which what is seen changes: the events of a scene.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/visibility/visible_lines.h"

namespace hottel {

// How far a critical line reaches beyond one of its vertices.
struct LineReach2 {
  // What the line meets first beyond the vertex, moved a little so that the vertices are on its left (right): a side of
  // a piece, or kSky. A covered side: the line runs in a solid there.
  PieceSideId left = kSky, right = kSky;
  // Where the farther of the two is met, in scene coordinates: the vertex itself where both begin at it or in a solid;
  // nothing where one is the sky.
  std::optional<Point2> end;
  // What the line separates here: the side of a piece (or kSky) that is seen between the two vertices by an eye on the
  // line just beyond this one, moved a little to the left (right) of from -> to. A covered side: that eye is in a
  // solid. kNoPiece where the line does not reach beyond the vertex.
  PieceSideId seen_from_left = kNoPiece, seen_from_right = kNoPiece;
};

// A line through two vertices that see each other, or are joined by a piece.
struct CriticalLine2 {
  Point2 from, to;               // the two vertices, in scene coordinates
  PieceSideId along = kNoPiece;  // the left side of the piece that joins them
  LineReach2 behind, ahead;      // beyond `from`, beyond `to`
};

// Returns the critical lines of a scene.
//
//   (1) exact: each pair of vertices once that has a free segment between them, or a piece, and for which what is met
//       beyond one of them on the left and on the right of the line are two different faces, or a face and the sky;
//       every line along a piece
//   (2) lines that run in solids are none
//   (3) in the order of vertices, and of what each sees counter-clockwise
//   (4) between `behind.end` and `ahead.end` the line crosses no piece
//   (5) an eye that crosses the line close to a vertex, beyond it, sees both vertices change places: what it sees
//       between them is seen_from_left on the left of the line, and seen_from_right on the right
//
// Lines through three or more vertices have an entry for each two that follow each other.
// Throws what progress throws, of the fraction done; Interrupted soon after a stop was asked for.
// COST: one sweep about every vertex, on all threads, and rational arithmetic for each line.
std::vector<CriticalLine2> critical_lines(const PreparedScene2& prepared,
                                          const std::function<void(double)>& progress = {});

}  // namespace hottel

// The region that a vertex sees, cut into wedges from which the surroundings of the vertex look the same.
#pragma once

#include <vector>

#include "geometry/plane/predicates/vertices.h"
#include "geometry/plane/visibility/view.h"

namespace hottel {

// A ray that starts at a vertex: along an axis, towards another vertex, or away from one. Kept
// by name, without rounding.
struct VertexRay2 {
  enum class Kind : unsigned char { kAxis, kTowards, kAwayFrom };
  Kind kind = Kind::kAxis;
  std::uint32_t index = 0;  // kAxis: quarter turns from the x axis; else the number of a vertex

  // Along the x axis after so many quarter turns counter-clockwise, 4 being 0 again; towards a vertex; away from one.
  static VertexRay2 axis(std::uint32_t quarter_turns) { return {Kind::kAxis, quarter_turns}; }
  static VertexRay2 towards(VertexId v) { return {Kind::kTowards, static_cast<std::uint32_t>(v.index())}; }
  static VertexRay2 away_from(VertexId v) { return {Kind::kAwayFrom, static_cast<std::uint32_t>(v.index())}; }
  VertexId vertex() const { return VertexId(index); }  // REQUIRES that it is none along an axis
};

// The points between two rays from a vertex, on its side of what ends the view there. From each of them one sees the
// vertex, with the same two piece sides (or the sky) next to it.
//
//   (1) the wedges of a vertex are disjoint, and every point that sees the vertex past no other vertex lies in one of
//       them or on a ray between two
//   (2) a wedge lies within one quadrant
struct Wedge2 {
  VertexRay2 right, left;
  PieceSideId behind;                 // ends the wedge; kSky: nothing does
  PieceSideId seen_left, seen_right;  // seen immediately left and right of the vertex
  friend bool same_sight(const Wedge2& a, const Wedge2& b) {
    return a.behind == b.behind && a.seen_left == b.seen_left && a.seen_right == b.seen_right;
  }
};

// Appends the wedges of vertex v, counter-clockwise from the x axis; view is what v sees.
//
//   (1) a wedge between two rays of one direction, which has no inside, is left out
//   (2) nothing is rounded: directions are compared by signs
// REQUIRES the view of v among these vertices. COST: about two orientations for each vertex seen.
void append_wedges(const Vertices2& vertices, VertexId v, const View2& view, std::vector<Wedge2>& wedges);

}  // namespace hottel

// A constrained triangulation of a scene, in flat arrays, labelled with what one sees when crossing each edge.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/plane/arrangement/overlay.h"
#include "geometry/plane/arrangement/piece_side.h"
#include "geometry/plane/predicates/vertices.h"

namespace hottel {

using TriangleId = Id<struct TriangleTag>;
using HalfEdgeId = Id<struct HalfEdgeTag>;

// Triangle t has the half-edges 0, 1 and 2, which follow each other counter-clockwise.
//
//   (1) triangle_of(half_edge(t, k)) == t and place_in_triangle(half_edge(t, k)) == k
//   (2) next_half_edge and previous_half_edge stay in the triangle and undo each other; three steps come back
//   (3) all of this is arithmetic on numbers: no triangulation is looked at
constexpr TriangleId triangle_of(HalfEdgeId h) { return TriangleId(h.number() / 3); }
constexpr HalfEdgeId half_edge(TriangleId t, int k) { return HalfEdgeId(3 * t.number() + k); }
constexpr std::array<HalfEdgeId, 3> half_edges_of(TriangleId t) {
  return {half_edge(t, 0), half_edge(t, 1), half_edge(t, 2)};
}
constexpr int place_in_triangle(HalfEdgeId h) { return h.number() % 3; }
constexpr HalfEdgeId next_half_edge(HalfEdgeId h) {
  return HalfEdgeId(place_in_triangle(h) == 2 ? h.number() - 2 : h.number() + 1);
}
constexpr HalfEdgeId previous_half_edge(HalfEdgeId h) {
  return HalfEdgeId(place_in_triangle(h) == 0 ? h.number() + 2 : h.number() - 1);
}

// What one comes upon behind an edge of a triangle: the triangle on its other side, by the half-edge through which one
// enters it, or the side of what stands on the edge.
class Beyond2 {
 public:
  explicit constexpr Beyond2(HalfEdgeId entry) : code_(entry.number()) {}
  explicit constexpr Beyond2(PieceSideId side) : code_(-2 - side.number()) {}

  constexpr bool is_open() const { return code_ >= 0; }
  constexpr HalfEdgeId entry() const { return HalfEdgeId(code_); }        // REQUIRES is_open()
  constexpr PieceSideId side() const { return PieceSideId(-2 - code_); }  // a side or kSky; REQUIRES !is_open()
  friend constexpr bool operator==(const Beyond2&, const Beyond2&) = default;

 private:
  std::int32_t code_;
};

// A triangle as one who enters it through a half-edge h meets it: the corner opposite h, what lies behind the edge from
// target(h) to it, to the right of who looks at the corner from h, and behind the one from it to origin(h).
struct Passage2 {
  VertexId corner;
  Beyond2 on_right, on_left;
};

// One neighbour of a vertex and what lies between it and the next one, counter-clockwise.
struct StarEntry2 {
  VertexId neighbour;
  HalfEdgeId opposite;      // of the triangle between this neighbour and the next one; none: the sky lies between them
  PieceSideId left, right;  // sides of the piece vertex-neighbour as seen on its left (right); kNoPiece if it is none
};

// A constrained Delaunay triangulation of the vertices, every piece an edge of it. Triangle t has the half-edges 3t,
// 3t+1, 3t+2; half-edge 3t+i runs from corner i+1 to corner i+2, opposite corner i, so that from corner i its origin
// is on the right and its target on the left.
//
//   (1) every piece is an edge of the triangulation; triangles are counter-clockwise and fill the convex hull
//   (2) is_open(h): nothing stands on the edge, and twin(h) is the half-edge on its other side. Else twin(h) is none,
//       and side(h) is the side of the piece that stands on it, as seen from inside the triangle, or kSky on an edge
//       of the convex hull that is no piece
//       beyond(h) tells the two together, and passage(h) has those of the other two edges of the triangle
//   (3) across(h) is the half-edge on the other side whatever stands there; none on the hull only
//   (4) of is_open(h), is_piece(h) and is_bare_hull(h) exactly one is true
//   (5) star(v) is in counter-clockwise order and holds every edge at v
//   (6) sweep_order() has each vertex once; what lies near each other follows each other there, and so it does in the
//       numbers of triangles: whoever goes from vertex to vertex this way finds in the cache what it meets
//
// Degenerate: where all vertices lie on one line there are no triangles; the star of a vertex then has the vertices
// next to it on the line, joined by a piece or not.
// SEE: insertion along a Hilbert curve in rounds (Amenta, Choi, Rote 2003), so that vertices on a convex outline do
// not cost O(n^2).
class Triangulation2 {
 public:
  Triangulation2() = default;
  // REQUIRES: the vertices are distinct points; the pieces have two different ends and meet in common ends only, and
  // no vertex lies inside a piece. Neither list is kept.
  Triangulation2(const Vertices2& vertices, const std::vector<Segment2>& pieces);

  std::size_t triangle_count() const { return passages_.size() / 3; }
  IdRange<TriangleId> triangles() const { return IdRange<TriangleId>(triangle_count()); }
  IdRange<HalfEdgeId> half_edges() const { return IdRange<HalfEdgeId>(passages_.size()); }
  const Passage2& passage(HalfEdgeId h) const { return passages_[h.index()]; }
  // The half-edge h runs from origin(h) to target(h), and corner(h) is the third corner of its triangle.
  VertexId corner(HalfEdgeId h) const { return passage(h).corner; }  // opposite half-edge h
  VertexId origin(HalfEdgeId h) const { return corner(next_half_edge(h)); }
  VertexId target(HalfEdgeId h) const { return corner(previous_half_edge(h)); }
  Beyond2 beyond(HalfEdgeId h) const { return passage(next_half_edge(h)).on_left; }
  bool is_open(HalfEdgeId h) const { return beyond(h).is_open(); }
  HalfEdgeId twin(HalfEdgeId h) const { return is_open(h) ? beyond(h).entry() : HalfEdgeId::none(); }
  HalfEdgeId across(HalfEdgeId h) const { return across_[h.index()]; }
  PieceSideId side(HalfEdgeId h) const { return beyond(h).side(); }  // where it is not open
  bool is_piece(HalfEdgeId h) const { return !is_open(h) && side(h) != kSky; }
  bool is_bare_hull(HalfEdgeId h) const { return !is_open(h) && side(h) == kSky; }
  // The neighbours of v. Where there are triangles, a vertex on the convex hull has one entry with opposite none: the
  // outside comes after it.
  std::span<const StarEntry2> star(VertexId v) const {
    return {star_.data() + star_begin_[v.index()], star_.data() + star_begin_[v.index() + 1]};
  }
  std::span<const VertexId> sweep_order() const { return sweep_order_; }

 private:
  std::vector<Passage2> passages_;  // what is asked together lies together
  std::vector<HalfEdgeId> across_;
  std::vector<VertexId> sweep_order_;
  std::vector<std::uint32_t> star_begin_;
  std::vector<StarEntry2> star_;
};

}  // namespace hottel

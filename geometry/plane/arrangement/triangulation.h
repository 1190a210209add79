// A constrained triangulation of a scene, in flat arrays, labelled with what one sees when crossing each edge.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/plane/arrangement/overlay.h"
#include "geometry/plane/predicates/vertices.h"

namespace hottel {

using HalfEdgeId = std::int32_t;
using PieceSideId = std::int32_t;  // 2 piece + 0 for the left side of a -> b, + 1 for its right side
inline constexpr PieceSideId kNoPiece = -1;
inline constexpr PieceSideId kSky = -1;

// The neighbours of a vertex in counter-clockwise order, with what lies between them.
struct StarEntry {
  VertexId neighbour;
  HalfEdgeId opposite;      // of the triangle between this neighbour and the next one; -1: the sky lies between them
  PieceSideId left, right;  // sides of the piece vertex-neighbour as seen on its left (right); kNoPiece if it is none
};

// Triangle t has the half-edges 3t, 3t+1, 3t+2; half-edge 3t+i runs from corner i+1 to corner i+2, opposite corner i,
// so that from corner i its origin is on the right and its target on the left.
//
//   (1) every piece is an edge of the triangulation; triangles are counter-clockwise and fill the convex hull
//   (2) twin(h) >= 0: nothing stands on the edge; twin(h) == -1: side(h) is the side of the piece that stands on it, as
//       seen from inside the triangle, or kSky on an edge of the convex hull that is no piece
//       across(h) is the half-edge on the other side whatever stands there
//   (3) star(v) is in counter-clockwise order and holds every edge at v; a scene on one line has stars, no triangles
class Triangulation2 {
 public:
  Triangulation2() = default;
  Triangulation2(const Vertices2& vertices, const std::vector<Segment2>& pieces);

  std::size_t triangle_count() const { return corner_.size() / 3; }
  VertexId corner(HalfEdgeId h) const { return corner_[static_cast<std::size_t>(h)]; }    // opposite half-edge h
  HalfEdgeId twin(HalfEdgeId h) const { return twin_[static_cast<std::size_t>(h)]; }      // -1 on a piece or the hull
  HalfEdgeId across(HalfEdgeId h) const { return across_[static_cast<std::size_t>(h)]; }  // -1 on the hull only
  PieceSideId side(HalfEdgeId h) const { return side_[static_cast<std::size_t>(h)]; }     // where twin is -1
  std::span<const StarEntry> star(VertexId v) const {
    return {star_.data() + star_begin_[v], star_.data() + star_begin_[v + 1]};
  }

 private:
  std::vector<VertexId> corner_;
  std::vector<HalfEdgeId> twin_;
  std::vector<HalfEdgeId> across_;
  std::vector<PieceSideId> side_;
  std::vector<std::uint32_t> star_begin_;
  std::vector<StarEntry> star_;
};

inline HalfEdgeId next_half_edge(HalfEdgeId h) { return h % 3 == 2 ? h - 2 : h + 1; }
inline HalfEdgeId previous_half_edge(HalfEdgeId h) { return h % 3 == 0 ? h + 2 : h - 1; }

}  // namespace hottel

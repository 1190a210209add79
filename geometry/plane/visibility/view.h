// What one sees from a point: triangular expansion through the constrained triangulation.
#pragma once

#include <cstdint>
#include <type_traits>
#include <vector>

#include "geometry/plane/arrangement/triangulation.h"
#include "geometry/plane/predicates/vertices.h"

namespace hottel {

// The visible vertices around an eye in counter-clockwise order, the nearest one in each direction, and what is seen
// between each and the next.
//
//   (1) the open segment from the eye to a seen vertex meets no piece and no other vertex, or it is covered by a piece
//       that ends at the eye (then left and right are the sides of that piece, else kNoPiece)
//   (2) between two neighbours in the list one sees exactly one side of one piece, or the sky (kSky)
//   (3) of vertices in one direction only the nearest is listed; none is listed twice
//   (4) exact, and independent of how the triangulation was made
// Degenerate: an eye that is a vertex or lies on a piece sees both sides of what ends or lies there; alone in the plane
// it sees nothing, and the list is empty. The memory of a view is used again by the next one.
struct View2 {
  struct Seen {
    VertexId vertex;
    PieceSideId behind;       // seen between this vertex and the next in the list
    PieceSideId left, right;  // sides of the covering piece
  };
  std::vector<Seen> seen;
};

// An eye of which only the signs are known: orientation(j, k) of two vertices.
template <class Orientation>
class PlainEye {
 public:
  struct Ray {
    VertexId vertex;
  };
  explicit PlainEye(const Orientation& orientation) : orientation_(orientation) {}
  Ray ray(VertexId j) const { return {j}; }
  int orientation(const Ray& j, const Ray& k) const { return orientation_(j.vertex, k.vertex); }
  bool turns_left(const Ray& j, const Ray& k) const { return orientation(j, k) > 0; }

 private:
  Orientation orientation_;
};

template <class Eye>
using RayOf = typename Eye::Ray;

// The eye at a vertex, by points.orientation(i, j, k).
template <class Points>
auto eye_at(const Points& points, VertexId v) {
  if constexpr (std::is_same_v<Points, Vertices2>)
    return VertexEye2(points, v);
  else
    return PlainEye([&points, v](VertexId j, VertexId k) { return points.orientation(v, j, k); });
}

// Follows the cone between right and left into the triangle of half-edge `entry`, which it enters through it,
// counter-clockwise; appends the vertices found strictly inside
// the cone and what is seen between them. Eye has a ray(v) to each vertex, whose member `vertex` is v, and a
// turns_left(j, k) of two rays, whether the triangle eye, j, k is counter-clockwise.
// REQUIRES: the last entry of the view is the right end.
// COST: one or two orientations for each triangle the cone enters; no recursion.
// SEE: triangular expansion: Bungiu, Hemmer, Hershberger, Huang, Kröller, Efficient computation of
// visibility polygons, 2014.
template <class Eye>
void expand_cone(const Triangulation2& triangulation, HalfEdgeId entry, RayOf<Eye> right, RayOf<Eye> left,
                 const Eye eye, View2& view) {
  using Ray = RayOf<Eye>;
  struct Cone {
    Beyond2 beyond;
    Ray right, left;
  };
  thread_local std::vector<Cone> waiting(64, Cone{Beyond2(entry), right, left});
  std::size_t depth = 0;  // how many of them wait
  for (Beyond2 beyond(entry);;) {
    if (!beyond.is_open()) {
      view.seen.back().behind = beyond.side();
      if (depth == 0) return;
      --depth;
      beyond = waiting[depth].beyond;
      right = waiting[depth].right;
      left = waiting[depth].left;
      view.seen.push_back({right.vertex, kSky, kNoPiece, kNoPiece});
      continue;
    }
    const Passage2& passage = triangulation.passage(beyond.entry());
    const Ray apex = eye.ray(passage.corner);
    if (!eye.turns_left(right, apex)) {
      beyond = passage.on_left;  // the whole cone passes left of the apex
    } else if (!eye.turns_left(apex, left)) {
      beyond = passage.on_right;
    } else {
      if (depth == waiting.size()) waiting.resize(2 * depth, waiting.front());
      waiting[depth++] = {passage.on_left, apex, left};
      beyond = passage.on_right;
      left = apex;
    }
  }
}

// The same for a cone that leaves the triangle of half-edge `exit` through it.
template <class Eye>
void expand_cone_through(const Triangulation2& triangulation, HalfEdgeId exit, VertexId right, VertexId left,
                         const Eye& eye, View2& view) {
  const Beyond2 beyond = triangulation.beyond(exit);
  if (beyond.is_open())
    expand_cone(triangulation, beyond.entry(), eye.ray(right), eye.ray(left), eye, view);
  else
    view.seen.back().behind = beyond.side();
}

// Fills the view from vertex v, by the signs of points.orientation(i, j, k). What the view held before is lost.
//
//   (1) every neighbour of v in the triangulation is in the list, in the order of star(v); vertices farther away
//       stand between them
//
// REQUIRES: the triangulation has the vertices that `points` knows.
template <class Points>
void look_around(const Points& points, const Triangulation2& triangulation, VertexId v, View2& view) {
  view.seen.clear();
  const auto star = triangulation.star(v);
  const auto eye = eye_at(points, v);
  for (std::size_t k = 0; k < star.size(); ++k) {
    const StarEntry2& entry = star[k];
    view.seen.push_back({entry.neighbour, kSky, entry.left, entry.right});
    if (entry.opposite.is_none()) continue;
    const VertexId next = star[k + 1 == star.size() ? 0 : k + 1].neighbour;
    expand_cone_through(triangulation, entry.opposite, entry.neighbour, next, eye, view);
  }
}

// The same by exact signs: then all that the view says is exact. COST: about 20 ns for each triangle seen.
void look_around(const Vertices2& vertices, const Triangulation2& triangulation, VertexId v, View2& view);

}  // namespace hottel

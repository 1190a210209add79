#include "geometry/plane/visibility/segment_visibility.h"

#include "kernel/support/failure.h"

namespace hottel {
namespace {

Point2 point_at(const Vertices2& vertices, const Segment2& run, const Rational& t) {
  const Point2 a = vertices.exact(run.a), b = vertices.exact(run.b);
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

bool is_piece(const StarEntry2& entry) { return entry.left != kNoPiece; }

// The next vertex of a run of pieces.
VertexId next_on(const Vertices2& vertices, const Triangulation2& triangulation, const Segment2& run, VertexId from) {
  for (const StarEntry2& entry : triangulation.star(from))
    if (is_piece(entry) && (entry.neighbour == run.b || (vertices.orientation(run.a, run.b, entry.neighbour) == 0 &&
                                                         vertices.direction_sign(from, entry.neighbour, run.b) > 0)))
      return entry.neighbour;
  throw_contract_violation("pieces on all of the run", __FILE__, __LINE__);
}

}  // namespace

RunPoint2::RunPoint2(const Arrangement2& arrangement, const Segment2& run, const Rational& t)
    : run_(run), eye_(arrangement.vertices(), point_at(arrangement.vertices(), run, t)) {
  HOTTEL_REQUIRE(t >= 0 && t <= 1);
  const Vertices2& vertices = arrangement.vertices();
  for (VertexId v = run.a;;) {
    if (v == run.b ? t == 1 : v == run.a ? t == 0 : eye_.coincides_with(v)) {
      is_vertex_ = true;
      vertex_ = v;
      return;
    }
    const VertexId next = next_on(vertices, arrangement.triangulation(), run, v);
    if (eye_.direction_sign(v, next) < 0) {
      stand_on(arrangement.triangulation(), v, next);
      return;
    }
    v = next;
  }
}

// The triangle right of from -> to is the one left of to -> from: that after the edge to `from` in the star of `to`.
void RunPoint2::stand_on(const Triangulation2& triangulation, VertexId from, VertexId to) {
  for (const StarEntry2& entry : triangulation.star(to))
    if (entry.neighbour == from && !entry.opposite.is_none()) gate_ = previous_half_edge(entry.opposite);
}

// On which side of a line that was moved a little the vertices lie: what was on it is on the side it was moved from.
struct SegmentVisibility2::Sides {
  const EyeLine2& line;
  Shift shift;
  bool met_vertex = false;  // a vertex lay on the line: the other shift may have another answer

  int of(VertexId v) {
    const int side = line.side(v);
    if (side != 0) return side;
    met_vertex = true;
    return -static_cast<int>(shift);
  }
};

bool SegmentVisibility2::see_each_other(const RunPoint2& p, const RunPoint2& q) const {
  if (q.eye_.orientation(p.run_.a, p.run_.b) >= 0 || p.eye_.orientation(q.run_.a, q.run_.b) >= 0) return false;
  const EyeLine2 line(p.eye_, q.eye_);
  Sides left{line, Shift::kLeft};
  if (is_free(p, q, left)) return true;
  if (!left.met_vertex) return false;
  Sides right{line, Shift::kRight};
  return is_free(p, q, right);
}

void SegmentVisibility2::look_around(const RunPoint2& p, View2& view) const {
  if (p.is_vertex_) {
    hottel::look_around(vertices_, triangulation_, p.vertex_, view);
    return;
  }
  view.seen.clear();
  if (p.gate_.is_none()) return;
  const PlainEye eye([&p](VertexId j, VertexId k) { return p.eye_.orientation(j, k); });
  for (const HalfEdgeId exit : {next_half_edge(p.gate_), previous_half_edge(p.gate_)}) {
    const VertexId right = triangulation_.origin(exit), left = triangulation_.target(exit);
    view.seen.push_back({right, kSky, kNoPiece, kNoPiece});
    expand_cone_through(triangulation_, exit, right, left, eye, view);
  }
}

// True iff no piece at a vertex where the segment ends lies between the segment and the line of the run, on the side to
// which the segment was moved.
bool SegmentVisibility2::passes_all_at(const RunPoint2& end, const Sides& sides) const {
  for (const StarEntry2& entry : triangulation_.star(end.vertex_))
    if (is_piece(entry) && sides.line.side(entry.neighbour) == static_cast<int>(sides.shift) &&
        vertices_.orientation(end.run_.a, end.run_.b, entry.neighbour) < 0)
      return false;
  return true;
}

bool SegmentVisibility2::is_free(const RunPoint2& p, const RunPoint2& q, Sides& sides) const {
  if (p.is_vertex_ || q.is_vertex_) sides.met_vertex = true;
  if (p.is_vertex_ && !passes_all_at(p, sides)) return false;
  if (q.is_vertex_ && !passes_all_at(q, sides)) return false;
  HalfEdgeId entry = p.gate_;
  if (p.is_vertex_) {
    const auto star = triangulation_.star(p.vertex_);
    std::size_t k = 0;
    const auto next = [&star](std::size_t i) { return i + 1 == star.size() ? 0 : i + 1; };
    while (k < star.size() &&
           !(!star[k].opposite.is_none() && sides.of(star[k].neighbour) < 0 && sides.of(star[next(k)].neighbour) > 0))
      ++k;
    // No triangle: the segment lies on the convex hull and was moved out of it.
    if (k == star.size()) return true;
    if (q.is_vertex_ && (star[k].neighbour == q.vertex_ || star[next(k)].neighbour == q.vertex_)) return true;
    const HalfEdgeId exit = star[k].opposite;
    entry = triangulation_.twin(exit);
    if (entry.is_none()) return exit == q.gate_;
  }
  for (;;) {
    const VertexId apex = triangulation_.corner(entry);
    if (q.is_vertex_ && apex == q.vertex_) return true;
    const HalfEdgeId exit = sides.of(apex) > 0 ? next_half_edge(entry) : previous_half_edge(entry);
    entry = triangulation_.twin(exit);
    if (entry.is_none()) return exit == q.gate_;
  }
}

}  // namespace hottel

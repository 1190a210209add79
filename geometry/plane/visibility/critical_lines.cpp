#include "geometry/plane/visibility/critical_lines.h"

#include <atomic>

#include "kernel/support/interrupt.h"
#include "kernel/support/parallel.h"

namespace hottel {
namespace {

class LineMaker {
 public:
  explicit LineMaker(const Arrangement2& arrangement) : arrangement_(arrangement), vertices_(arrangement.vertices()) {}

  // The line of a gap, unless it is no event.
  std::optional<CriticalLine2> line(const Gap2& gap) const {
    const bool is_along = gap.covered_left != kNoPiece;
    if (!is_along && is_same(gap.behind_left, gap.behind_right) && is_same(gap.ahead_left, gap.ahead_right))
      return std::nullopt;
    const bool is_inside = is_along ? is_covered(gap.covered_left) && is_covered(gap.covered_right)
                                    : is_covered(gap.behind_left) || is_covered(gap.behind_right) ||
                                          is_covered(gap.ahead_left) || is_covered(gap.ahead_right);
    if (is_inside) return std::nullopt;
    const Point2 v = vertices_.exact(gap.v), w = vertices_.exact(gap.w);
    CriticalLine2 line{vertices_.to_scene(v), vertices_.to_scene(w), gap.covered_left,
                       reach(w, v, gap.behind_left, gap.behind_right), reach(v, w, gap.ahead_left, gap.ahead_right)};
    // From beyond one vertex, on the left of the line, one looks between both to its right: past the vertex near by
    // unless a piece stands there on the left, through the segment unless a piece covers it, and then as a line does
    // that leaves the far vertex on its left. From the right the other way round.
    if (line.behind.end != line.from) {
      line.behind.seen_from_left = seen_past(gap.v, gap.w, 1, gap.covered_left, gap.ahead_left);
      line.behind.seen_from_right = seen_past(gap.v, gap.w, -1, gap.covered_right, gap.ahead_right);
    }
    if (line.ahead.end != line.to) {
      line.ahead.seen_from_left = seen_past(gap.w, gap.v, -1, gap.covered_left, gap.behind_left);
      line.ahead.seen_from_right = seen_past(gap.w, gap.v, 1, gap.covered_right, gap.behind_right);
    }
    return line;
  }

 private:
  bool is_covered(PieceSideId side) const { return side != kSky && arrangement_.is_covered(side); }
  bool is_same(PieceSideId p, PieceSideId q) const {
    if (p == q) return true;
    if (p == kSky || q == kSky || is_covered(p) || is_covered(q)) return false;
    return static_cast<const Face&>(arrangement_.owner(p)) == arrangement_.owner(q);
  }

  // What is met first by who looks along the line from behind `near` towards `far` and passes `near` on the left (turn
  // 1) or on the right (-1): a piece at `near` on that side, of several the one turned farthest from `far`; else what
  // covers the segment between; else `beyond`.
  PieceSideId seen_past(VertexId near, VertexId far, int turn, PieceSideId covering, PieceSideId beyond) const {
    const StarEntry2* first = nullptr;
    for (const StarEntry2& entry : arrangement_.triangulation().star(near)) {
      if (entry.left == kNoPiece || vertices_.orientation(near, far, entry.neighbour) != turn) continue;
      if (!first || vertices_.orientation(near, first->neighbour, entry.neighbour) == turn) first = &entry;
    }
    if (first) return turn > 0 ? first->left : first->right;
    return covering != kNoPiece ? covering : beyond;
  }

  // How far beyond q, in multiples of q - p, the line from p through q meets a side. REQUIRES that it does.
  Rational distance(const Point2& p, const Point2& q, PieceSideId side) const {
    const Segment2& piece = arrangement_.piece(side);
    const Point2 a = vertices_.exact(piece.a), b = vertices_.exact(piece.b);
    const Rational wx = b.x - a.x, wy = b.y - a.y;
    return ((a.x - q.x) * wy - (a.y - q.y) * wx) / ((q.x - p.x) * wy - (q.y - p.y) * wx);
  }

  LineReach2 reach(const Point2& p, const Point2& q, PieceSideId left, PieceSideId right) const {
    LineReach2 result{left, right, std::nullopt};
    Rational farthest = 0;
    for (const PieceSideId side : {left, right}) {
      if (side == kSky) return result;
      if (is_covered(side)) continue;
      const Rational t = distance(p, q, side);
      if (t > farthest) farthest = t;
    }
    result.end = vertices_.to_scene({q.x + farthest * (q.x - p.x), q.y + farthest * (q.y - p.y)});
    return result;
  }

  const Arrangement2& arrangement_;
  const Vertices2& vertices_;
};

}  // namespace

std::vector<CriticalLine2> critical_lines(const PreparedScene2& prepared, const std::function<void(double)>& progress) {
  const Arrangement2& arrangement = prepared.arrangement;
  const Vertices2& vertices = arrangement.vertices();
  const LineMaker maker(arrangement);
  std::vector<std::vector<CriticalLine2>> by_vertex(vertices.size());
  std::atomic<std::size_t> done{0};
  parallel_ranges(by_vertex.size(), 16, [&](std::size_t begin, std::size_t end) {
    View2 view;
    for (std::size_t k = begin; k < end; ++k) {
      throw_if_interrupted();
      const VertexId v(k);
      look_around(vertices, arrangement.triangulation(), v, view);
      for_each_gap(vertices, v, view, true, [&](const Gap2& gap) {
        if (auto line = maker.line(gap)) by_vertex[k].push_back(*std::move(line));
      });
    }
    const std::size_t so_far = done += end - begin;
    if (progress) progress(static_cast<double>(so_far) / static_cast<double>(by_vertex.size()));
  });
  std::vector<CriticalLine2> result;
  for (auto& lines : by_vertex)
    for (CriticalLine2& line : lines) result.push_back(std::move(line));
  return result;
}

}  // namespace hottel

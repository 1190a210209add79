#include "geometry/plane/visibility/critical_points.h"

#include <algorithm>
#include <tuple>

#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/visibility/visible_lines.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

class Collector {
 public:
  Collector(const Arrangement2& arrangement, const Scene2& scene, const Face& a, const std::optional<Face>& b)
      : arrangement_(arrangement), a_(a), b_(b) {
    const Vertices2& vertices = arrangement.vertices();
    const auto& [from, to] = scene.edges[a.surface];
    from_ = vertices.from_scene(from);
    to_ = vertices.from_scene(to);
  }

  void look_along(const Gap2& gap) {
    look(gap.v, gap.w, gap.behind_left, gap.behind_right, gap.ahead_left, gap.ahead_right, gap);
    look(gap.w, gap.v, gap.ahead_left, gap.ahead_right, gap.behind_left, gap.behind_right, gap);
  }

  std::vector<CriticalPoint2> take() {
    const auto key = [](const CriticalPoint2& c) { return std::tie(c.t, c.near.x, c.near.y, c.far.x, c.far.y); };
    std::sort(found_.begin(), found_.end(), [&](const auto& p, const auto& q) { return key(p) < key(q); });
    found_.erase(
        std::unique(found_.begin(), found_.end(), [&](const auto& p, const auto& q) { return key(p) == key(q); }),
        found_.end());
    return std::move(found_);
  }

 private:
  bool is(PieceSideId side, const std::optional<Face>& face) const {
    if (!face || side == kSky) return !face && side == kSky;
    return !arrangement_.is_covered(side) && arrangement_.owner(side) == *face;
  }

  // The line runs from face a past vertex near, then past vertex far.
  void look(VertexId near, VertexId far, PieceSideId here_left, PieceSideId here_right, PieceSideId there_left,
            PieceSideId there_right, const Gap2& gap) {
    if (!is(here_left, a_) && !is(here_right, a_)) return;
    const bool is_covered_by_b =
        gap.covered_left != kNoPiece && (is(gap.covered_left, b_) || is(gap.covered_right, b_));
    const bool changes = is(there_left, b_) != is(there_right, b_) || is_covered_by_b;
    if (!changes) return;
    const Vertices2& vertices = arrangement_.vertices();
    const Point2 p = vertices.exact(near), q = vertices.exact(far);
    const Rational ux = to_.x - from_.x, uy = to_.y - from_.y, dx = q.x - p.x, dy = q.y - p.y;
    const Rational turn = ux * dy - uy * dx;
    if (turn == 0) return;
    const Rational t = ((p.x - from_.x) * dy - (p.y - from_.y) * dx) / turn;
    if (t < 0 || t > 1) return;
    if ((t == 0 && p == from_) || (t == 1 && p == to_)) return;  // the face's own ends
    const Point2 x{from_.x + t * ux, from_.y + t * uy};
    found_.push_back({t, vertices.to_scene(x), vertices.to_scene(p), vertices.to_scene(q), x == p});
  }

  const Arrangement2& arrangement_;
  const Face a_;
  const std::optional<Face> b_;
  Point2 from_, to_;  // of surface a, in integer form
  std::vector<CriticalPoint2> found_;
};

}  // namespace

std::vector<CriticalPoint2> critical_points(const Arrangement2& arrangement, const Scene2& scene, const Face& a,
                                            const std::optional<Face>& b) {
  Collector collector(arrangement, scene, a, b);
  View2 view;
  const Vertices2& vertices = arrangement.vertices();
  for (const VertexId v : vertices.ids()) {
    look_around(vertices, arrangement.triangulation(), v, view);
    for_each_gap(vertices, v, view, true, [&](const Gap2& gap) { collector.look_along(gap); });
  }
  return collector.take();
}

std::vector<CriticalPoint2> critical_points(const PreparedScene2& prepared, const Face& a,
                                            const std::optional<Face>& b) {
  HOTTEL_REQUIRE(a.surface < prepared.scene.surfaces.size() && (!b || b->surface < prepared.scene.surfaces.size()));
  return critical_points(prepared.arrangement, prepared.scene, a, b);
}

}  // namespace hottel

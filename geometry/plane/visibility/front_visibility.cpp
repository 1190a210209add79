#include "geometry/plane/visibility/front_visibility.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "kernel/written_double.h"

namespace hottel {
namespace {

// Of parts that no front sees.
constexpr std::uint32_t kUnseen = kNoSolid - 1;

// How a direction lies to half a turn from another one: -1 before, 0 at it, 1 beyond. Counter-clockwise, or clockwise;
// what lies along the other one itself is before at the beginning of a turn and beyond at its end.
int half_turn(const Point2& from, const Point2& direction, bool is_clockwise, bool is_beginning) {
  const int turn = sgn(cross(from, direction)) * (is_clockwise ? -1 : 1);
  if (turn != 0) return -turn;
  if (dot(from, direction) < 0) return 0;
  return is_beginning ? -1 : 1;
}

class FrontKeeper {
 public:
  FrontKeeper(const Arrangement2& arrangement, VisibilityPolygon2& polygon)
      : arrangement_(arrangement), polygon_(polygon) {}

  void keep() {
    const std::vector<View2::Seen>& seen = polygon_.view.seen;
    std::vector<std::size_t> pieces;  // places in the view of what ends at the eye
    for (std::size_t k = 0; k < seen.size(); ++k)
      if (seen[k].left != kNoPiece) pieces.push_back(k);
    if (pieces.empty()) return;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      const std::size_t end = p + 1 < pieces.size() ? pieces[p + 1] : pieces[0] + seen.size();
      keep_in_sector(pieces[p], end);
    }
    polygon_.parts = std::move(kept_);
    tell_area();
  }

 private:
  using Part = VisibilityPolygon2::Part;

  Point2 direction(std::size_t seen) const {
    const std::vector<View2::Seen>& all = polygon_.view.seen;
    const Vertices2& vertices = arrangement_.vertices();
    return minus(vertices.to_scene(vertices.exact(all[seen % all.size()].vertex)), polygon_.eye);
  }
  bool is_front(PieceSideId side) const { return !arrangement_.is_covered(side) && !arrangement_.owner(side).is_back; }

  // Between two pieces, from one counter-clockwise to the next, by their places in the view.
  void keep_in_sector(std::size_t begin, std::size_t end) {
    const std::vector<View2::Seen>& seen = polygon_.view.seen;
    const bool first = is_front(seen[begin].left), last = is_front(seen[end % seen.size()].right);
    for (std::size_t k = begin; k < end; ++k) {
      const Part& part = polygon_.parts[k % seen.size()];
      if (first == last)
        add(part, first);
      else
        add_before_line(part, direction(first ? begin : end), !first);
    }
  }

  void add(Part part, bool is_kept) {
    if (!is_kept) part.solid = kUnseen;
    kept_.push_back(std::move(part));
  }

  // What of a part lies within half a turn of a piece with its front there.
  void add_before_line(const Part& part, const Point2& piece, bool is_clockwise) {
    const int from = half_turn(piece, minus(part.from, polygon_.eye), is_clockwise, !is_clockwise);
    const int to = half_turn(piece, minus(part.to, polygon_.eye), is_clockwise, is_clockwise);
    const int near = is_clockwise ? to : from, far = is_clockwise ? from : to;
    if (far <= 0) return add(part, true);
    if (near >= 0) return add(part, false);
    Part right = part, left = part;
    right.to = left.from = place_along(part, {-piece.x, -piece.y});
    add(std::move(right), !is_clockwise);
    add(std::move(left), is_clockwise);
  }

  // A point of a part in a direction.
  Point2 place_along(const Part& part, const Point2& ray) const {
    const Point2& eye = polygon_.eye;
    if (part.side == kSky) return {eye.x + ray.x, eye.y + ray.y};
    const Point2 along = minus(part.to, part.from);
    const Rational t = cross(minus(part.from, eye), along) / cross(ray, along);
    return {eye.x + t * ray.x, eye.y + t * ray.y};
  }

  void tell_area() {
    Rational twice = 0;
    polygon_.area.reset();
    for (const Part& part : polygon_.parts) {
      if (part.solid != kNoSolid) continue;
      if (part.side == kSky) return;
      twice += cross(minus(part.from, polygon_.eye), minus(part.to, polygon_.eye));
    }
    polygon_.area = twice / 2;
  }

  const Arrangement2& arrangement_;
  VisibilityPolygon2& polygon_;
  std::vector<Part> kept_;
};

}  // namespace

void keep_fronts(const Arrangement2& arrangement, VisibilityPolygon2& polygon) {
  if (polygon.solid == kNoSolid) FrontKeeper(arrangement, polygon).keep();
}

RoundedPolygon2 rounded_polygon(const VisibilityPolygon2& polygon, bool wants_exact) {
  RoundedPolygon2 result;
  result.solid = polygon.solid;
  const auto is_free = [&](std::size_t k) { return polygon.parts[k % polygon.parts.size()].solid == kNoSolid; };
  std::vector<std::pair<Point2, PieceSideId>> corners;
  const auto add = [&corners](const Point2& at, PieceSideId after) {
    if (corners.empty() || !(corners.back().first == at)) return corners.emplace_back(at, after), void();
    corners.back().second = after;
  };
  for (std::size_t k = 0; k < polygon.parts.size(); ++k) {
    const VisibilityPolygon2::Part& part = polygon.parts[k];
    if (!is_free(k)) continue;
    add(part.from, part.side);
    add(part.to, kNoPiece);
    if (is_free(k + 1)) continue;
    std::size_t next = k + 1;
    while (!is_free(next)) ++next;
    const Point2 from = minus(part.to, polygon.eye),
                 to = minus(polygon.parts[next % polygon.parts.size()].from, polygon.eye);
    if (cross(from, to) != 0 || dot(from, to) > 0) add(polygon.eye, kNoPiece);
  }
  while (corners.size() > 1 && corners.front().first == corners.back().first) corners.pop_back();
  for (auto& [at, after] : corners) {
    result.corners.push_back({written_double(at.x), written_double(at.y), after});
    if (wants_exact) result.exact.push_back(std::move(at));
  }
  return result;
}

}  // namespace hottel

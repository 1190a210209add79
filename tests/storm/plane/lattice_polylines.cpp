#include "tests/storm/plane/lattice_polylines.h"

#include <algorithm>

namespace hottel::storm {

namespace {

using oracle::Behind;

struct Point {
  long x, y;
  bool operator==(const Point&) const = default;
};

struct Polyline {
  std::vector<Point> points;
  bool is_closed = true;
};

struct Box {
  long x0, y0, x1, y1;
};

std::vector<Point> corners(const Box& box) {
  return {{box.x0, box.y0}, {box.x1, box.y0}, {box.x1, box.y1}, {box.x0, box.y1}};
}

class Pen {
 public:
  Pen(std::mt19937_64& random, int k) : random_(random), k_(k) {}

  long below(long count) { return static_cast<long>(random_() % static_cast<std::uint64_t>(count)); }
  long between(long low, long high) { return low + below(high - low + 1); }
  bool chance(long one_in) { return below(one_in) == 0; }
  Point point() { return {below(k_ + 1), below(k_ + 1)}; }

  // A box within another, at least `least` wide and high. REQUIRES that there is one.
  Box box_in(const Box& around, long least) {
    Box box{};
    box.x0 = between(around.x0, around.x1 - least), box.x1 = between(box.x0 + least, around.x1);
    box.y0 = between(around.y0, around.y1 - least), box.y1 = between(box.y0 + least, around.y1);
    return box;
  }
  Box box(long least = 1) { return box_in({0, 0, k_, k_}, std::min<long>(least, k_)); }

  std::vector<Point> some_points(long count) {
    std::vector<Point> points{point()};
    while (static_cast<long>(points.size()) < count) {
      const Point next = point();
      if (!(next == points.back()) && !(static_cast<long>(points.size()) == count - 1 && next == points.front()))
        points.push_back(next);
    }
    return points;
  }

  std::vector<Point> there_and_back() {
    std::vector<Point> points = some_points(between(2, 3));
    for (std::size_t k = points.size() - 1; k-- > 1;) points.push_back(points[k]);
    return points;
  }

  std::vector<Point> box_with_spur() {
    std::vector<Point> points = corners(box());
    const auto at = static_cast<std::size_t>(below(4));
    const Point corner = points[at];
    Point tip = point();
    while (tip == corner) tip = point();
    points.insert(points.begin() + static_cast<std::ptrdiff_t>(at), {corner, tip});
    return points;
  }

  // Around the outer box counter-clockwise, over a bridge, around the inner one clockwise, and back.
  std::vector<Point> ring() {
    const Box outer = box(2), inner = box_in(outer, 1);
    std::vector<Point> points = corners(outer), hole = corners(inner);
    std::reverse(hole.begin() + 1, hole.end());
    points.push_back(points.front());
    points.insert(points.end(), hole.begin(), hole.end());
    points.push_back(hole.front());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.back() == points.front()) points.pop_back();
    return points;
  }

  std::vector<Point> walk() {
    std::vector<Point> points{point()};
    const long steps = between(2, 4);
    for (long step = 0; step < steps; ++step) {
      Point next = points.back();
      long& moved = chance(2) ? next.x : next.y;
      moved += moved == k_ || (moved > 0 && chance(2)) ? -1 : 1;
      points.push_back(next);
    }
    // Home along the axes.
    while (!(points.back() == points.front())) {
      Point next = points.back();
      if (next.x != points.front().x)
        next.x += next.x < points.front().x ? 1 : -1;
      else
        next.y += next.y < points.front().y ? 1 : -1;
      points.push_back(next);
    }
    points.pop_back();
    return points;
  }

 private:
  std::mt19937_64& random_;
  long k_;
};

std::vector<Polyline> draw(Pen& pen) {
  switch (pen.below(12)) {
    case 0:
    case 1:
      return {Polyline{corners(pen.box())}};
    case 2:
    case 3: {
      const Box box = pen.box(2), room = pen.box_in(box, 1);
      std::vector<Point> walls = corners(room);
      if (pen.chance(3)) walls.erase(walls.begin() + pen.below(4));
      std::reverse(walls.begin(), walls.end());
      return {Polyline{corners(box)}, Polyline{walls}};
    }
    case 4:
      return {Polyline{pen.some_points(pen.between(3, 5))}};
    case 5:
      return {Polyline{pen.there_and_back()}};
    case 6:
      return {Polyline{pen.box_with_spur()}};
    case 7:
      return {Polyline{pen.ring()}};
    case 8:
    case 9: {
      std::vector<Point> sides = corners(pen.box());
      std::rotate(sides.begin(), sides.begin() + pen.below(4), sides.end());
      std::vector<Polyline> result{Polyline{sides, false}};
      if (!pen.chance(3)) result.push_back({{sides[0], sides[3]}, false});
      return result;
    }
    case 10:
      return {Polyline{pen.walk()}};
    default:
      return {Polyline{pen.some_points(pen.between(3, 4)), false}};
  }
}

Behind say(Pen& pen, bool is_likely) {
  if (!pen.chance(is_likely ? 2 : 5)) return Behind::kNothingSaid;
  return pen.chance(3) ? Behind::kOpen : Behind::kSolid;
}

}  // namespace

void add_polylines(std::mt19937_64& random, int k, std::vector<LatticeEdge>& lattice,
                   std::vector<oracle::InputSegment>& edges) {
  Pen pen(random, k);
  for (oracle::InputSegment& edge : edges) edge.behind = say(pen, false);
  int group = 0;
  for (long count = pen.between(1, 3); count > 0; --count)
    for (const Polyline& polyline : draw(pen)) {
      const std::vector<Point>& points = polyline.points;
      if (points.size() < 2) continue;
      oracle::InputSegment edge;
      edge.front_material = static_cast<int>(pen.below(3));
      if (pen.chance(5)) edge.back_material = static_cast<int>(pen.below(3));
      edge.behind = say(pen, !polyline.is_closed);
      edge.group = group++;
      for (std::size_t p = 0; p + (polyline.is_closed ? 0 : 1) < points.size(); ++p) {
        const Point &a = points[p], &b = points[(p + 1) % points.size()];
        lattice.push_back({a.x, a.y, b.x, b.y});
        edge.ax = a.x, edge.ay = a.y, edge.bx = b.x, edge.by = b.y;
        edges.push_back(edge);
      }
    }
}

}  // namespace hottel::storm

#include "tests/oracle/plane/visible_pairs.h"

#include <algorithm>
#include <optional>
#include <set>

namespace hottel::oracle {
namespace {

using Point = std::pair<mpq_class, mpq_class>;

// Twice the area of a b c: positive iff c lies left of a -> b.
mpq_class area(const Point& a, const Point& b, const Point& c) {
  return (b.first - a.first) * (c.second - a.second) - (b.second - a.second) * (c.first - a.first);
}

bool is_between(const Point& a, const Point& b, const Point& c) {
  if (area(a, b, c) != 0) return false;
  const mpq_class along = (b.first - a.first) * (c.first - a.first) + (b.second - a.second) * (c.second - a.second);
  const mpq_class whole = (b.first - a.first) * (b.first - a.first) + (b.second - a.second) * (b.second - a.second);
  return 0 < along && along < whole;
}

Point start(const Segment& s) { return {s.ax, s.ay}; }
Point end(const Segment& s) { return {s.bx, s.by}; }

bool crosses(const Segment& s, const Point& a, const Point& b) {
  return sgn(area(a, b, start(s))) * sgn(area(a, b, end(s))) < 0 &&
         sgn(area(start(s), end(s), a)) * sgn(area(start(s), end(s), b)) < 0;
}

// Does what is met first to the right of a point, which lies on no piece, look into a solid?
bool is_in_solid(const std::vector<Segment>& pieces, Point p) {
  mpq_class nothing;
  mpq_div_2exp(nothing.get_mpq_t(), mpq_class(1).get_mpq_t(), 300);
  p.second += nothing;  // past all vertices
  std::optional<mpq_class> nearest;
  int label = kInfinity;
  for (const Segment& s : pieces) {
    if ((s.ay < p.second) == (s.by < p.second)) continue;
    const mpq_class x = s.ax + (p.second - s.ay) / (s.by - s.ay) * (s.bx - s.ax);
    if (x <= p.first || (nearest && *nearest <= x)) continue;
    nearest = x;
    label = s.ay < s.by ? s.left : s.right;  // the side that looks to smaller x
  }
  return label == kCovered;
}

}  // namespace

std::vector<VisiblePair> visible_pairs(const std::vector<Segment>& pieces) {
  std::set<Point> vertices;
  for (const Segment& s : pieces) {
    vertices.insert(start(s));
    vertices.insert(end(s));
  }
  std::vector<VisiblePair> result;
  for (const Point& v : vertices)
    for (const Point& w : vertices) {
      if (!(v < w)) continue;
      if (std::any_of(vertices.begin(), vertices.end(), [&](const Point& u) { return is_between(v, w, u); })) continue;
      const auto joining = std::find_if(pieces.begin(), pieces.end(), [&](const Segment& s) {
        return (start(s) == v && end(s) == w) || (start(s) == w && end(s) == v);
      });
      if (joining != pieces.end()) {
        if (joining->left != kCovered || joining->right != kCovered) result.push_back({v, w, true});
        continue;
      }
      if (std::any_of(pieces.begin(), pieces.end(), [&](const Segment& s) { return crosses(s, v, w); })) continue;
      if (!is_in_solid(pieces, {(v.first + w.first) / 2, (v.second + w.second) / 2})) result.push_back({v, w, false});
    }
  return result;
}

}  // namespace hottel::oracle

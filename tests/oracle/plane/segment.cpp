#include "tests/oracle/plane/segment.h"

#include <stdexcept>

namespace hottel::oracle {
namespace {

struct Point {
  mpq_class x, y;
};

Point start(const InputSegment& edge) { return {edge.ax, edge.ay}; }
Point end(const InputSegment& edge) { return {edge.bx, edge.by}; }

Point on_line(const Point& a, const Point& b, const mpq_class& t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

// Twice the area of a b c: positive iff c lies left of a -> b.
mpq_class area(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// t of the point of a -> b that lies on the line through c and d, which is not parallel to it.
mpq_class meeting(const Point& a, const Point& b, const Point& c, const Point& d) {
  const mpq_class at_a = area(c, d, a), at_b = area(c, d, b);
  return at_a / (at_a - at_b);
}

bool looks_at(const EdgePoint& from, const Point& to) {
  const mpq_class side = area(start(from.edge), end(from.edge), to);
  return from.looks_left ? side > 0 : side < 0;
}

}  // namespace

bool see_each_other(const std::vector<InputSegment>& edges, const EdgePoint& p, const EdgePoint& q) {
  const Point from = on_line(start(p.edge), end(p.edge), p.t), to = on_line(start(q.edge), end(q.edge), q.t);
  if (!looks_at(p, to) || !looks_at(q, from)) return false;
  mpq_class nothing;
  mpq_div_2exp(nothing.get_mpq_t(), mpq_class(1).get_mpq_t(), 300);
  for (const int shift : {1, -1}) {
    const mpq_class x = -shift * nothing * (to.y - from.y), y = shift * nothing * (to.x - from.x);
    const Point a{from.x + x, from.y + y}, b{to.x + x, to.y + y};
    const mpq_class first = meeting(a, b, start(p.edge), end(p.edge)), last = meeting(a, b, start(q.edge), end(q.edge));
    bool is_free = true;
    for (const InputSegment& edge : edges) {
      const int side_a = sgn(area(a, b, start(edge))), side_b = sgn(area(a, b, end(edge)));
      if (side_a == 0 || side_b == 0) throw std::logic_error("the shift is not small enough to miss all vertices");
      if (side_a == side_b) continue;
      const mpq_class t = meeting(a, b, start(edge), end(edge));
      if (first < t && t < last) is_free = false;
    }
    if (is_free) return true;
  }
  return false;
}

}  // namespace hottel::oracle

// The line through two free points against exact rationals.
#include "geometry/plane/predicates/eye_line.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "tests/geometry/plane/exact_signs.h"

namespace hottel::eye_line_test {
namespace {

using exact_signs::exact_orientation;

using Points = std::vector<Point2>;

Rational number(const char* text) { return *parse_rational(text); }

// `from` and `to` in scene coordinates.
void check(const Points& points, const Point2& from, const Point2& to) {
  const Vertices2 vertices(points, points.size());
  const Eye2 p(vertices, vertices.from_scene(from)), q(vertices, vertices.from_scene(to));
  const EyeLine2 forth(p, q), back(q, p);
  for (const VertexId v : IdRange<VertexId>(points.size())) {
    ASSERT_EQ(forth.side(v), exact_orientation(from, to, points[v.index()])) << v.index();
    ASSERT_EQ(back.side(v), -forth.side(v)) << v.index();
  }
}

TEST(EyeLine2, Coverage) {
  const Points small{{0, 0}, {4, 0}, {4, 3}, {0, 3}, {2, 1}, {1, 1}, {3, 3}};
  Points large = small;
  large.push_back({number("0.123456789012345678901234567890123456789"), number("1/3")});
  for (const Points& points : {small, large}) {
    check(points, {0, 0}, {4, 3});  // through vertices
    check(points, {number("1/2"), number("1/2")}, {number("5/2"), number("5/2")});
    check(points, {number("1/3"), number("1/3")}, {number("5/7"), number("5/7")});  // different denominators
    check(points, {number("1/3"), number("1/5")}, {number("5/7"), number("5/11")});
    check(points, {1 + number("1e-30"), 1}, {2, 1 + number("1e-30")});  // beside two vertices
    check(points, {number("1e25"), number("-1e25")}, {2, 1});
    check(points, {number("1e400"), number("1e400")}, {0, 0});  // beyond the range of double
    check(points, {number("1e308"), number("1.7e308")}, {number("-1e308"), 0});
  }
}

// Points on the line through two vertices, moved off it by less and less.
TEST(EyeLine2, Consistency) {
  std::mt19937_64 random(1);
  for (const int bits : {6, 30, 53, 59}) {
    Points points{{0, 0}};
    for (int k = 0; k < 8; ++k) {
      const auto coordinate = [&] { return Rational(Integer(random() >> (64 - bits))); };
      points.push_back({coordinate(), coordinate()});
    }
    for (int k = 0; k < 300; ++k) {
      const Point2 &p = points[random() % 9], &q = points[random() % 9];
      if (p == q) continue;
      const auto draw = [&] {
        Rational t(static_cast<long>(random() % 4001) - 2000, static_cast<long>(random() % 1000) + 1);
        t.canonicalize();
        Integer power;
        mpz_ui_pow_ui(power.get_mpz_t(), 10, random() % 50);
        const Rational off = Rational(static_cast<long>(random() % 3) - 1) / power;
        return Point2{p.x + t * (q.x - p.x) - off * (q.y - p.y), p.y + t * (q.y - p.y) + off * (q.x - p.x)};
      };
      const Point2 from = draw(), to = draw();
      if (!(from == to)) check(points, from, to);
    }
  }
}

}  // namespace
}  // namespace hottel::eye_line_test

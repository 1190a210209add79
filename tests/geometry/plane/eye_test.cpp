// Predicates of a free eye against exact rationals.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "geometry/plane/predicates/vertices.h"
#include "tests/geometry/plane/exact_signs.h"

namespace hottel::eye_test {
namespace {

using exact_signs::exact_direction;
using exact_signs::exact_orientation;

using Points = std::vector<Point2>;

// `eye` in scene coordinates.
void check(const Points& points, const Point2& eye) {
  const Vertices2 vertices(points, points.size());
  const Eye2 look(vertices, vertices.from_scene(eye));
  for (const VertexId j : IdRange<VertexId>(points.size())) {
    EXPECT_EQ(look.coincides_with(j), points[j.index()] == eye);
    for (const VertexId k : IdRange<VertexId>(points.size())) {
      EXPECT_EQ(look.orientation(j, k), exact_orientation(eye, points[j.index()], points[k.index()]))
          << j.index() << " " << k.index();
      EXPECT_EQ(look.direction_sign(j, k), exact_direction(eye, points[j.index()], points[k.index()]))
          << j.index() << " " << k.index();
    }
  }
}

Rational number(const char* text) { return *parse_rational(text); }

const Points& short_scene() {
  static const Points points{{0, 0}, {4, 0}, {4, 3}, {0, 3}, {2, 1}, {1, 1}, {3, 3}};
  return points;
}

Points long_scene() {
  Points points = short_scene();
  points.push_back({number("0.123456789012345678901234567890123456789"), number("1/3")});
  return points;
}

TEST(Eye2, Coverage) {
  for (const Points& points : {short_scene(), long_scene()}) {
    check(points, {2, 2});                                      // collinear with others
    check(points, {4, 3});                                      // on a vertex
    check(points, {2, 0});                                      // on an edge
    check(points, {number("1/3"), number("1/7")});              // no double
    check(points, {1 + number("1e-30"), 1 + number("1e-30")});  // beside a vertex, on a line through two
    check(points, {1 + number("1e-30"), 1 - number("1e-30")});  // beside it
    check(points, {number("1e25"), number("-1e25")});           // far away
    check(points, {number("1e400"), number("1e400")});          // beyond the range of double
    check(points, {number("-1e4000"), number("1e-4000")});      // both
    check(points, {number("1e308"), number("1.7e308")});        // where differences and products overflow
    check(points, {number("0.1234567890123456789"), number("3")});
  }
}

// Eyes moved off the line through two vertices by less and less.
TEST(Eye2, Consistency) {
  std::mt19937_64 random(1);
  for (const bool large : {false, true})
    for (const int bits : {6, 30, 53, 59}) {
      Points points{{0, 0}};
      for (int k = 0; k < 8; ++k) {
        const auto coordinate = [&] { return Rational(Integer(random() >> (64 - bits))); };
        points.push_back({coordinate(), coordinate()});
      }
      if (large) points.push_back(long_scene().back());
      const Vertices2 vertices(points, points.size());
      EXPECT_NE(vertices.is_small(), large);
      for (int k = 0; k < 200; ++k) {
        const Point2 &p = points[random() % 9], &q = points[random() % 9];
        Rational t(static_cast<long>(random() % 4001) - 2000, static_cast<long>(random() % 1000) + 1);
        t.canonicalize();
        Integer power;
        mpz_ui_pow_ui(power.get_mpz_t(), 10, random() % 50);
        const Rational off = Rational(static_cast<long>(random() % 3) - 1) / power;
        const Point2 eye{p.x + t * (q.x - p.x) - off * (q.y - p.y), p.y + t * (q.y - p.y) + off * (q.x - p.x)};
        const Eye2 look(vertices, vertices.from_scene(eye));
        for (const VertexId i : IdRange<VertexId>(points.size()))
          for (const VertexId j : IdRange<VertexId>(i.index())) {
            ASSERT_EQ(look.orientation(i, j), exact_orientation(eye, points[i.index()], points[j.index()]));
            ASSERT_EQ(look.direction_sign(i, j), exact_direction(eye, points[i.index()], points[j.index()]));
          }
      }
    }
}

}  // namespace
}  // namespace hottel::eye_test

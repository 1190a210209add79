// Predicates of vertices against exact rationals.
#include "geometry/plane/predicates/vertices.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "tests/geometry/plane/exact_signs.h"
#include "tests/geometry/plane/vertex_literal.h"

namespace hottel::vertices_test {
namespace {

using exact_signs::exact_direction;
using exact_signs::exact_orientation;

using Points = std::vector<Point2>;

Rational fraction(const Integer& p, const Integer& q) {
  Rational value(p, q);
  value.canonicalize();
  return value;
}

int exact_side_of_circle(const Point2& p, const Point2& q, const Point2& r, const Point2& s) {
  const auto lift = [&s](const Point2& t) -> Rational { return (t.x - s.x) * (t.x - s.x) + (t.y - s.y) * (t.y - s.y); };
  const auto minor = [&s](const Point2& t, const Point2& u) -> Rational {
    return (t.x - s.x) * (u.y - s.y) - (t.y - s.y) * (u.x - s.x);
  };
  const Rational value = lift(p) * minor(q, r) + lift(q) * minor(r, p) + lift(r) * minor(p, q);
  return sgn(value);
}

// Makes the vertices take the large form without touching the other points.
Point2 spoiler() { return {fraction(1, (Integer(1) << 200) + 1), fraction(1, 3)}; }

Points from_doubles(const std::vector<std::pair<double, double>>& coordinates) {
  Points points;
  for (const auto& [x, y] : coordinates) points.push_back({Rational(x), Rational(y)});
  return points;
}

// Words and big numbers come to the same integers: those without a common factor.
TEST(Vertices2Form, DoesNotDependOnHowLongTheCoordinatesAre) {
  std::mt19937_64 random(9);
  const auto coordinate = [&random](int kind) -> Rational {
    const long value = static_cast<long>(random() % 2001) - 1000;
    switch (kind) {
      case 0:
        return value;
      case 1:
        return fraction(value, 1000);
      case 2:
        return fraction(value, static_cast<long>(random() % 12) + 1);
      default:
        return fraction(value * 6, 35);
    }
  };
  const Rational stretch = fraction((Integer(1) << 300) * 7, 11);
  for (int scene = 0; scene < 200; ++scene) {
    Points points, far;
    for (int k = 0; k < 2 + scene % 7; ++k) points.push_back({coordinate(scene % 4), coordinate(scene % 4)});
    points.push_back(points.front());
    points.back().x += fraction(1, 1 + scene % 5);  // not all are one point
    for (const Point2& p : points) far.push_back({p.x * stretch, p.y * stretch});
    const std::size_t typed = scene % 3 == 0 ? points.size() - 1 : points.size();
    const Vertices2 words(points, typed), big(far, typed);
    ASSERT_TRUE(words.is_small());
    ASSERT_TRUE(big.is_small());
    EXPECT_EQ(words.scale() * stretch, big.scale()) << scene;
    EXPECT_EQ(words.exponent(), big.exponent());
    EXPECT_EQ(words.approximation_error(), big.approximation_error());
    for (const VertexId v : words.ids()) {
      EXPECT_EQ(words.exact(v), big.exact(v)) << scene;
      EXPECT_EQ(words.to_scene(words.exact(v)), points[v.index()]) << scene;
    }
  }
}

TEST(Vertices2Form, IsSmallWhereACommonDenominatorMakesItSo) {
  EXPECT_TRUE(Vertices2(Points{}, 0).is_small());
  EXPECT_TRUE(Vertices2(from_doubles({{0, 0}, {1, 2}}), 2).is_small());
  EXPECT_TRUE(Vertices2(from_doubles({{0.1, 0.2}, {0.3, 0.7}}), 2).is_small());
  EXPECT_TRUE(Vertices2(Points{{fraction(1, 3), fraction(1, 7)}, {fraction(1, 10), 5}}, 2).is_small());
  EXPECT_TRUE(Vertices2(from_doubles({{1e300, 0}, {0, 1e300}}), 2).is_small()) << "a common factor is taken out";
  EXPECT_FALSE(Vertices2(from_doubles({{0, 0}, {1e300, 1}}), 2).is_small());
  EXPECT_FALSE(Vertices2(Points{{0, 0}, {1, 1}, spoiler()}, 3).is_small());
  // The widest small coordinate has 60 bits.
  const Rational widest = (Integer(1) << 60) - 1;
  EXPECT_TRUE(Vertices2(Points{{0, 0}, {widest, 1}}, 2).is_small());
  EXPECT_FALSE(Vertices2(Points{{0, 0}, {widest + 1, 1}}, 2).is_small());
  EXPECT_FALSE(Vertices2(Points{{-widest, 0}, {widest, 1}}, 2).is_small()) << "the first point is the origin";
}

TEST(Vertices2Form, KeepsTheExactPoints) {
  const Points points{{fraction(1, 3), fraction(1, 7)}, {fraction(1, 10), 5}, {-2, fraction(22, 7)}};
  for (const bool large : {false, true}) {
    Points all = points;
    if (large) all.push_back(spoiler());
    const Vertices2 vertices(all, all.size());
    EXPECT_EQ(vertices.is_small(), !large);
    for (const VertexId v : IdRange<VertexId>(all.size())) {
      EXPECT_EQ(vertices.to_scene(vertices.exact(v)), all[v.index()]);
      EXPECT_EQ(vertices.from_scene(all[v.index()]), vertices.exact(v));
    }
  }
}

void check_all_triples(const Points& points, const char* what) {
  for (const bool large : {false, true}) {
    Points all = points;
    if (large) all.push_back(spoiler());
    const Vertices2 vertices(all, all.size());
    EXPECT_TRUE(!large || !vertices.is_small());
    for (const VertexId i : IdRange<VertexId>(points.size()))
      for (const VertexId j : IdRange<VertexId>(points.size()))
        for (const VertexId k : IdRange<VertexId>(points.size())) {
          EXPECT_EQ(vertices.orientation(i, j, k),
                    exact_orientation(points[i.index()], points[j.index()], points[k.index()]))
              << what << ": " << i.index() << " " << j.index() << " " << k.index();
          EXPECT_EQ(vertices.direction_sign(i, j, k),
                    exact_direction(points[i.index()], points[j.index()], points[k.index()]));
          const VertexEye2 eye(vertices, i);
          EXPECT_EQ(eye.orientation(eye.ray(j), eye.ray(k)), vertices.orientation(i, j, k)) << what;
          EXPECT_EQ(eye.turns_left(eye.ray(j), eye.ray(k)), vertices.orientation(i, j, k) > 0) << what;
        }
  }
}

// Where doubles are wrong: the examples of Kettner, Mehlhorn, Pion, Schirra and Yap.
TEST(Orientation2, IsRightWhereDoublesFail) {
  const Points page_13 = from_doubles({{0.10000000000000001, 0.10000000000000001},
                                       {0.20000000000000001, 0.20000000000000004},
                                       {0.79999999999999993, 0.80000000000000004},
                                       {1.267650600228229e30, 1.2676506002282291e30}});
  const Vertices2 four(page_13, 4);
  EXPECT_EQ(four.orientation(0_v, 1_v, 2_v), -1);
  EXPECT_EQ(four.orientation(0_v, 1_v, 3_v), -1);
  EXPECT_EQ(four.orientation(0_v, 2_v, 3_v), -1);
  EXPECT_EQ(four.orientation(1_v, 2_v, 3_v), -1);
  check_all_triples(page_13, "page 13");

  const Points a1 = from_doubles({{7.3000000000000194, 7.3000000000000167},
                                  {24.000000000000068, 24.000000000000071},
                                  {24.00000000000005, 24.000000000000053},
                                  {0.50000000000001621, 0.50000000000001243},
                                  {8, 4},
                                  {4, 9},
                                  {15, 27},
                                  {26, 25},
                                  {19, 11}});
  EXPECT_EQ(Vertices2(a1, a1.size()).orientation(0_v, 1_v, 3_v), 1);
  EXPECT_EQ(Vertices2(a1, a1.size()).orientation(0_v, 2_v, 3_v), 1);
  check_all_triples(a1, "A1");
  const Points a2 = from_doubles({{27.643564356435643, -21.881188118811881},
                                  {83.366336633663366, 15.544554455445542},
                                  {4, 4},
                                  {73.415841584158414, 8.8613861386138595}});
  EXPECT_EQ(Vertices2(a2, 4).orientation(0_v, 1_v, 3_v), 1);
  check_all_triples(a2, "A2");
  check_all_triples(from_doubles({{200, 49.200000000000003},
                                  {100, 49.600000000000001},
                                  {-233.33333333333334, 50.93333333333333},
                                  {166.66666666666669, 49.333333333333336}}),
                    "B1");
  check_all_triples(from_doubles({{0.50000000000001243, 0.50000000000000189},
                                  {0.50000000000001243, 0.50000000000000333},
                                  {24.00000000000005, 24.000000000000053},
                                  {24.000000000000068, 24.000000000000071},
                                  {17.300000000000001, 17.300000000000001}}),
                    "B2");
}

int orientation_in_doubles(double px, double py, double qx, double qy, double rx, double ry) {
  const double value = (qx - px) * (ry - py) - (qy - py) * (rx - px);
  return (value > 0) - (value < 0);
}

struct NeighbourGrid {
  double px, py, step, q, r;
};

class Orientation2OnNeighbouringDoubles : public testing::TestWithParam<NeighbourGrid> {};

// 256 x 256 neighbouring doubles around a point on the line through two others.
TEST_P(Orientation2OnNeighbouringDoubles, HasTheExactSign) {
  const auto [px, py, step, q, r] = GetParam();
  constexpr int kSide = 256;
  for (const bool large : {false, true}) {
    Points points = from_doubles({{q, q}, {r, r}});
    for (int i = 0; i < kSide; ++i)
      for (int j = 0; j < kSide; ++j) points.push_back({Rational(px + i * step), Rational(py + j * step)});
    if (large) points.push_back(spoiler());
    const Vertices2 vertices(points, points.size());
    EXPECT_NE(vertices.is_small(), large);
    int wrong = 0, wrong_in_doubles = 0, zeros = 0;
    for (int i = 0; i < kSide; ++i)
      for (int j = 0; j < kSide; ++j) {
        const auto p = VertexId(2 + i * kSide + j);
        const int exact = exact_orientation(points[p.index()], points[0], points[1]);
        wrong += vertices.orientation(p, 0_v, 1_v) != exact;
        wrong += vertices.orientation(0_v, 1_v, p) != exact;
        wrong += vertices.orientation(1_v, 0_v, p) != -exact;
        wrong_in_doubles += orientation_in_doubles(px + i * step, py + j * step, q, q, r, r) != exact;
        zeros += exact == 0;
      }
    EXPECT_EQ(wrong, 0);
    EXPECT_GT(wrong_in_doubles, 1000) << "the grid is hard";
    EXPECT_TRUE(px != py || zeros == kSide);
  }
}

INSTANTIATE_TEST_SUITE_P(Grids, Orientation2OnNeighbouringDoubles,
                         testing::Values(NeighbourGrid{0.5, 0.5, 0x1p-53, 12, 24},
                                         NeighbourGrid{0.5, 0.5, 0x1p-53, 8.8000000000000007, 12.1},
                                         NeighbourGrid{0.50000000000002531, 0.5000000000000171, 0x1p-53,
                                                       17.300000000000001, 24.00000000000005}));

TEST(Orientation2, Coverage) {
  // Small form: settled by the filter, by 128-bit integers, collinear.
  const Integer big = Integer(1) << 59;
  const Points small{{0, 0}, {Rational(big), Rational(big - 1)}, {Rational(big - 1), Rational(big - 2)}, {1, 5}};
  check_all_triples(small, "128-bit integers");
  EXPECT_EQ(Vertices2(small, 4).orientation(0_v, 1_v, 2_v), -1);
  check_all_triples(from_doubles({{0, 0}, {3, 1}, {6, 2}, {-9, -3}, {0, 0}}), "collinear");
  // Coordinates beyond 2^53 are no doubles.
  check_all_triples({{0, 0}, {Rational(big + 1), 1}, {Rational(-big - 1), -1}, {Rational(big), 1}}, "rounded input");
  // Large form beyond and below the range of double.
  const Rational huge = *parse_rational("1e4000"), tiny = *parse_rational("1e-4000");
  check_all_triples({{0, 0}, {huge, huge}, {huge, huge + tiny}, {tiny, tiny}, {tiny, 2 * tiny}}, "1e4000");
}

// Points moved off a line by less and less, down to 1e-50 of the extent.
TEST(Orientation2, Consistency) {
  std::mt19937_64 random(1);
  for (int k = 0; k < 400; ++k) {
    const auto number = [&] {
      return fraction(Integer(random() >> 20) - (Integer(1) << 43), Integer(random() >> 50) + 1);
    };
    const Point2 p{number(), number()}, q{number(), number()};
    Points points{p, q};
    for (int digits = 1; digits <= 50; digits += 7) {
      const Rational t = fraction(static_cast<long>(random() % 2001) - 1000, 500);
      Integer power;
      mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(digits));
      const Rational off = fraction(static_cast<long>(random() % 3) - 1, power);
      points.push_back({p.x + t * (q.x - p.x) - off * (q.y - p.y), p.y + t * (q.y - p.y) + off * (q.x - p.x)});
    }
    const Vertices2 vertices(points, points.size());
    for (const VertexId i : IdRange<VertexId>(points.size()))
      for (const VertexId j : IdRange<VertexId>(i.index()))
        for (const VertexId l : IdRange<VertexId>(j.index()))
          ASSERT_EQ(vertices.orientation(i, j, l),
                    exact_orientation(points[i.index()], points[j.index()], points[l.index()]));
  }
}

TEST(Vertices2Order, ComparesExactCoordinates) {
  const Rational tiny = *parse_rational("1e-60");
  for (const Rational& step : {Rational(1), tiny}) {
    const Points points{{0, 0}, {1, 1}, {1 + step, 1 - step}, {1, 1 - step}};
    const Vertices2 vertices(points, points.size());
    for (const VertexId i : IdRange<VertexId>(4))
      for (const VertexId j : IdRange<VertexId>(4)) {
        EXPECT_EQ(vertices.compare_x(i, j), sgn(Rational(points[i.index()].x - points[j.index()].x)));
        EXPECT_EQ(vertices.compare_y(i, j), sgn(Rational(points[i.index()].y - points[j.index()].y)));
        const bool precedes = points[i.index()].x < points[j.index()].x ||
                              (points[i.index()].x == points[j.index()].x && points[i.index()].y < points[j.index()].y);
        EXPECT_EQ(vertices.precedes(i, j), precedes);
      }
  }
}

TEST(Vertices2Order, KnowsWhatLiesBetween) {
  for (const bool large : {false, true}) {
    Points points = from_doubles({{0, 0}, {6, 3}, {2, 1}, {8, 4}, {-2, -1}});
    if (large) points.push_back(spoiler());
    const Vertices2 vertices(points, points.size());
    EXPECT_TRUE(vertices.is_between(0_v, 1_v, 2_v));
    EXPECT_FALSE(vertices.is_between(0_v, 1_v, 3_v));
    EXPECT_FALSE(vertices.is_between(0_v, 1_v, 4_v));
    EXPECT_FALSE(vertices.is_between(0_v, 1_v, 0_v));
    EXPECT_FALSE(vertices.is_between(0_v, 1_v, 1_v));
  }
}

TEST(Vertices2Order, IsInvariantUnderTranslationAndScaling) {
  const Points points = from_doubles({{0, 0}, {3, 1}, {6, 2}, {-9, 4}, {5, 5}});
  const Rational shift = *parse_rational("9007199254740993");
  for (const char* factor : {"1048576", "1/3", "1e-300", "1e300", "1e-4000"}) {
    Points moved;
    for (const Point2& p : points)
      moved.push_back({(p.x + shift) * *parse_rational(factor), (p.y - shift) * *parse_rational(factor)});
    const Vertices2 a(points, points.size()), b(moved, moved.size());
    EXPECT_TRUE(b.is_small());
    for (const VertexId i : IdRange<VertexId>(points.size())) {
      EXPECT_EQ(a.exact(i), b.exact(i));
      for (const VertexId j : IdRange<VertexId>(points.size()))
        EXPECT_EQ(a.distance(i, j).value, b.distance(i, j).value);
    }
  }
}

void check_circles(const Points& points, int tries) {
  const Vertices2 vertices(points, points.size());
  std::mt19937_64 random(7);
  int zeros = 0;
  for (int k = 0; k < tries; ++k) {
    const auto any = [&] { return static_cast<VertexId>(random() % points.size()); };
    VertexId a = any(), b = any();
    const VertexId c = any(), d = any();
    if (exact_orientation(points[a.index()], points[b.index()], points[c.index()]) < 0) std::swap(a, b);
    if (exact_orientation(points[a.index()], points[b.index()], points[c.index()]) == 0) continue;
    const int exact = exact_side_of_circle(points[a.index()], points[b.index()], points[c.index()], points[d.index()]);
    zeros += exact == 0;
    ASSERT_EQ(vertices.side_of_circle(a, b, c, d), exact)
        << a.index() << " " << b.index() << " " << c.index() << " " << d.index();
  }
  EXPECT_GT(zeros, 0);
}

TEST(SideOfCircle2, Coverage) {
  const Vertices2 vertices(from_doubles({{0, 0}, {2, 0}, {0, 2}, {2, 2}, {1, 1}, {3, 3}}), 6);
  EXPECT_EQ(vertices.side_of_circle(0_v, 1_v, 2_v, 3_v), 0);
  EXPECT_EQ(vertices.side_of_circle(0_v, 1_v, 2_v, 4_v), 1);
  EXPECT_EQ(vertices.side_of_circle(0_v, 1_v, 2_v, 5_v), -1);
}

// Points of one circle, moved by one unit here and there, at all sizes of coordinates and in both forms.
TEST(SideOfCircle2, Consistency) {
  for (const int bits : {4, 20, 26, 27, 28, 29, 40, 52, 56}) {
    std::mt19937_64 random(static_cast<std::uint64_t>(bits));
    Points points;
    const Rational scale = Integer(1) << static_cast<unsigned long>(bits);
    // Pythagorean directions with the common hypotenuse 65 * 5 = 325.
    const long legs[][2] = {{36, 323}, {80, 315}, {91, 312}, {125, 300}, {165, 280}, {195, 260}, {204, 253}, {325, 0}};
    for (const auto& [x, y] : legs)
      for (const int sx : {-1, 1})
        for (const int sy : {-1, 1}) {
          points.push_back({sx * x * scale / 256, sy * y * scale / 256});
          points.push_back({sy * y * scale / 256 + static_cast<long>(random() % 3) - 1, sx * x * scale / 256});
        }
    check_circles(points, 3000);
    points.push_back(spoiler());
    check_circles(points, 1500);
  }
}

}  // namespace
}  // namespace hottel::vertices_test

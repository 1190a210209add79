// What many eyes decide at once, against exact rationals eye by eye.
#include "geometry/plane/predicates/eye_tile.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "tests/geometry/plane/exact_signs.h"

namespace hottel::eye_tile_test {
namespace {

using exact_signs::exact_orientation;

using Points = std::vector<Point2>;

Rational number(const char* text) { return *parse_rational(text); }

// Eyes at from + k * step in scene coordinates: some groups of them about every pair of points.
void check(const Points& points, const Point2& from, const Rational& step, std::size_t columns, std::size_t rows) {
  const Vertices2 vertices(points, points.size());
  std::vector<EyeCoordinate2> x, y;
  std::vector<Point2> eyes(EyeTile2::kSide * EyeTile2::kSide);
  const auto place = [&](std::size_t k, const Rational& first) -> Rational {
    return first + step * static_cast<long>(k);
  };
  for (std::size_t k = 0; k < columns; ++k) x.emplace_back(vertices, vertices.from_scene({place(k, from.x), 0}).x);
  for (std::size_t k = 0; k < rows; ++k) y.emplace_back(vertices, vertices.from_scene({0, place(k, from.y)}).y);
  const EyeTile2 tile(vertices, x, y);
  ASSERT_EQ(tile.columns(), columns);
  ASSERT_EQ(tile.rows(), rows);
  EyeTile2::Set all = 0;
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < columns; ++column) {
      const std::size_t k = EyeTile2::kSide * row + column;
      all |= EyeTile2::Set{1} << k;
      eyes[k] = {place(column, from.x), place(row, from.y)};
      ASSERT_EQ(vertices.to_scene(tile.eye(k).exact()), eyes[k]);
    }
  std::mt19937_64 random(1);
  for (const EyeTile2::Set some :
       {~EyeTile2::Set{0}, EyeTile2::Set{random() & random() & random()}, EyeTile2::Set{0xff} << 8, EyeTile2::Set{1}}) {
    if ((some & all) == 0) continue;
    const EyeTile2::Group group = tile.group(some & all);
    for (const VertexId i : IdRange<VertexId>(points.size()))
      for (const VertexId j : IdRange<VertexId>(points.size())) {
        EyeTile2::Set expected = 0;
        for (std::size_t k = 0; k < eyes.size(); ++k)
          if ((some & all) >> k & 1 && exact_orientation(eyes[k], points[i.index()], points[j.index()]) > 0)
            expected |= EyeTile2::Set{1} << k;
        ASSERT_EQ(tile.seeing_left_turn(group, i, j), expected) << i.index() << " " << j.index();
      }
  }
}

const Points kSmall{{0, 0}, {4, 0}, {4, 3}, {0, 3}, {2, 1}, {1, 1}, {3, 3}};

Points large() {
  Points points = kSmall;
  points.push_back({number("0.123456789012345678901234567890123456789"), number("1/3")});
  return points;
}

TEST(EyeTile2, Coverage) {
  for (const Points& points : {kSmall, large()}) {
    check(points, {0, 0}, number("1/2"), 8, 8);                           // on vertices and on lines through them
    check(points, {-20, -20}, 1, 8, 8);                                   // beside all lines but some
    check(points, {number("1/3"), number("1/7")}, number("1/11"), 5, 3);  // no doubles
    check(points, {1 - number("4e-30"), 1 - number("3e-30")}, number("1e-30"), 8, 7);  // as near as can be
    check(points, {number("1e25"), number("-1e25")}, number("1e23"), 8, 8);
    check(points, {number("1e308"), number("-1e308")}, number("1e307"), 8, 8);  // where differences overflow
    check(points, {number("1e400"), number("1e-400")}, number("1e-400"), 1, 8);
    check(points, {number("-1e400"), 1}, number("1e400"), 3, 1);
  }
}

// Tiles about points on the lines through two vertices, smaller and smaller.
TEST(EyeTile2, Consistency) {
  std::mt19937_64 random(1);
  for (const bool is_large : {false, true})
    for (const int bits : {6, 30, 53, 59}) {
      Points points{{0, 0}};
      const auto coordinate = [&] { return Rational(Integer(random() >> (64 - bits))); };
      while (points.size() < 6) points.push_back({coordinate(), coordinate()});
      if (is_large) points.push_back(large().back());
      for (int k = 0; k < 24; ++k) {
        const Point2 &p = points[random() % 6], &q = points[random() % 6];
        Rational t(static_cast<long>(random() % 4001) - 2000, static_cast<long>(random() % 1000) + 1);
        t.canonicalize();
        Integer power;
        mpz_ui_pow_ui(power.get_mpz_t(), 10, random() % 40);
        const Rational step = Rational(Integer(1ul << bits / 2)) / power;
        const Point2 at{p.x + t * (q.x - p.x) - 3 * step, p.y + t * (q.y - p.y) - 3 * step};
        check(points, at, step, 1 + random() % 8, 1 + random() % 8);
      }
    }
}

}  // namespace
}  // namespace hottel::eye_tile_test

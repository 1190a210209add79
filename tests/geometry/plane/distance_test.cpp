// Lengths in fixed point against roots with 400 bits.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "geometry/plane/predicates/vertices.h"
#include "tests/geometry/plane/vertex_literal.h"

namespace hottel::distance_test {
namespace {

using Points = std::vector<Point2>;

mpf_class to_float(const Rational& value) { return mpf_class(value, 600); }

// How far value lies from the real length, in units of fixed_unit().
mpf_class defect(const Vertices2& vertices, VertexId i, VertexId j) {
  const mpf_class root = sqrt(to_float(vertices.squared_distance(i, j)));
  const mpf_class value = to_float(Rational(to_integer(vertices.distance(i, j).value)) * vertices.fixed_unit());
  return abs(mpf_class(value - root, 600)) / to_float(vertices.fixed_unit());
}

void check(const Vertices2& vertices, VertexId i, VertexId j) {
  const FixedLength2 length = vertices.distance(i, j);
  const mpf_class error = defect(vertices, i, j);
  EXPECT_GE(length.value, 0);
  EXPECT_EQ(vertices.distance(j, i).value, length.value);
  if (length.is_exact) {
    EXPECT_LT(error, to_float(Rational(1, Integer(1) << 200))) << "said to be exact";
  } else {
    EXPECT_LE(error, vertices.length_error()) << vertices.squared_distance(i, j) << " unit " << vertices.fixed_unit();
  }
}

// Integer coordinates whose squared length has every number of bits, odd and even.
TEST(Distance2, IsWithinItsErrorInSmallForm) {
  std::mt19937_64 random(1);
  for (int top = 1; top <= 60; ++top) {
    for (const double diameters : {1.0, 1e3, 1e9}) {
      // The first point is the origin and one of the others has the full size; so the fixed unit is as coarse as it
      // gets.
      const Integer full = (Integer(1) << static_cast<unsigned long>(top)) - 1;
      Points points{{0, 0}, {Rational(full), Rational(full)}, {Rational(-full), 0}, {1, 0}, {0, -1}};
      for (int bits = 1; bits <= top; ++bits)
        for (int k = 0; k < 3; ++k) {
          const auto coordinate = [&] {
            const Integer value(random() >> (64 - bits));
            return Rational(random() % 2 == 0 ? value : Integer(-value));
          };
          points.push_back({coordinate(), k == 0 ? Rational(0) : coordinate()});
        }
      Vertices2 vertices(points, points.size());
      ASSERT_TRUE(vertices.is_small());
      vertices.set_total_length(diameters);
      for (const VertexId i : IdRange<VertexId>(points.size()))
        for (const VertexId j : IdRange<VertexId>(5)) check(vertices, i, j);
    }
  }
}

// Squared lengths 4^k - 1, 4^k, 4^k + 1, 2 4^k and the like: where the number of bits changes and roots are integers.
TEST(Distance2, IsWithinItsErrorNextToPowersOfTwo) {
  for (unsigned long k = 1; k < 60; ++k) {
    const Rational power = Integer(1) << k;
    Points points{{0, 0}};
    for (const int dx : {-1, 0, 1})
      for (const Rational& y : {Rational(0), Rational(1), Rational(power - 1), power})
        if (power + dx < Rational(Integer(1) << 60)) points.push_back({power + dx, y});
    const Vertices2 vertices(points, points.size());
    for (const VertexId i : IdRange<VertexId>(points.size()))
      for (const VertexId j : IdRange<VertexId>(i.index())) check(vertices, i, j);
  }
}

TEST(Distance2, IsExactForIntegersInSmallForm) {
  std::mt19937_64 random(2);
  const auto is_exact = [](const Rational& x, const Rational& y, const Rational& length) {
    const Vertices2 vertices(Points{{0, 0}, {x, y}, {1, 0}}, 3);
    const FixedLength2 found = vertices.distance(0_v, 1_v);
    return found.is_exact && Rational(to_integer(found.value)) * vertices.fixed_unit() * vertices.scale() == length;
  };
  EXPECT_TRUE(is_exact(3, 4, 5));
  EXPECT_TRUE(is_exact(0, 7, 7));
  EXPECT_TRUE(is_exact(Rational(3, 10), Rational(4, 10), Rational(1, 2)));
  EXPECT_EQ(Vertices2(Points{{0, 0}, {1, 0}}, 2).distance(0_v, 0_v).value, 0);
  EXPECT_TRUE(Vertices2(Points{{0, 0}, {1, 0}}, 2).distance(0_v, 0_v).is_exact);
  EXPECT_FALSE(Vertices2(Points{{0, 0}, {1, 1}}, 2).distance(0_v, 1_v).is_exact);
  for (int k = 0; k < 1000; ++k) {
    const Integer m = Integer(random() >> (36 + random() % 20)) + 2, n = Integer(random()) % (m - 1) + 1;
    const Integer x = m * m - n * n, y = 2 * m * n, z = m * m + n * n;
    EXPECT_TRUE(is_exact(x, y, z)) << x << " " << y;
  }
}

// Rationals with long denominators, from far apart to nearly the same point.
TEST(Distance2, IsWithinItsErrorInLargeForm) {
  std::mt19937_64 random(3);
  const auto any = [&](int bits) {
    Integer numerator = 0;
    for (int k = 0; k < 4; ++k) numerator = (numerator << 64) + Integer(random());
    Rational value(numerator - (Integer(1) << 255), (Integer(1) << 255) + 2 * Integer(random()) + 1);
    value.canonicalize();
    mpq_mul_2exp(value.get_mpq_t(), value.get_mpq_t(), 400);
    mpq_div_2exp(value.get_mpq_t(), value.get_mpq_t(), static_cast<unsigned long>(400 - bits));
    return value;
  };
  for (const int top : {-300, -70, 0, 1, 31, 64, 300}) {
    for (const double diameters : {1.0, 7.0, 1e6}) {
      Points points{{any(top), any(top)}, {any(top), any(top)}};
      for (int below = 0; below < 140; below += 3) {
        const Point2& base = points[static_cast<std::size_t>(random() % 2)];
        points.push_back({base.x + any(top - below), base.y + (below % 2 == 0 ? any(top - below) : Rational(0))});
      }
      Vertices2 vertices(points, points.size());
      ASSERT_FALSE(vertices.is_small());
      vertices.set_total_length(diameters);
      for (const VertexId i : IdRange<VertexId>(points.size()))
        for (const VertexId j : IdRange<VertexId>(i.index())) check(vertices, i, j);
    }
  }
}

TEST(Distance2, IsEqualForEqualDifferences) {
  std::mt19937_64 random(4);
  Points points;
  for (int k = 0; k < 50; ++k) {
    const Rational x(static_cast<long>(random() % 1000)), y(static_cast<long>(random() % 1000));
    for (const auto& [dx, dy] : {std::pair(0, 0), std::pair(37, -11)}) points.push_back({x + dx, y + dy});
  }
  const Vertices2 vertices(points, points.size());
  for (std::size_t k = 2; k < points.size(); k += 2)
    EXPECT_EQ(vertices.distance(VertexId(k), VertexId(k + 1)).value, vertices.distance(0_v, 1_v).value);
}

TEST(Distance2, FitsTheTotalThatWasAskedFor) {
  const Integer full = (Integer(1) << 60) - 1;
  for (const double diameters : {1.0, 1e3, 1e9}) {
    Vertices2 vertices(Points{{0, 0}, {Rational(full), Rational(full)}, {Rational(full), Rational(-full)}}, 3);
    vertices.set_total_length(diameters);
    // The longest distance is below 3 of the largest coordinate; twice the total must stay below 2^124.
    const Integer length = to_integer(vertices.distance(1_v, 2_v).value);
    EXPECT_LT(Rational(length) * Rational(diameters), Rational(Integer(1) << 123));
    EXPECT_GT(length, Integer(1) << 80) << "and no bit is given away needlessly";
  }
}

}  // namespace
}  // namespace hottel::distance_test

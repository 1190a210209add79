// Exact questions about points with short and with long coordinates, held against Integers.
#include "geometry/space/arrangement/short_integers.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <utility>

namespace hottel {
namespace {

// Numbers of up to so many bits, the largest ones and zero among them.
class Numbers {
 public:
  Integer next(int bits) {
    const auto kind = engine_() % 8;
    if (kind == 0) return 0;
    const Integer most = (Integer(1) << static_cast<unsigned>(bits)) - 1;
    Integer size = kind == 1 ? most : Integer(static_cast<unsigned long>(engine_())) * 0x9e3779b97f4a7c15ul % most;
    return engine_() % 2 == 0 ? size : Integer(-size);
  }
  IntegerVector vector(int bits) {
    Integer x = next(bits), y = next(bits);
    return {std::move(x), std::move(y), next(bits)};
  }
  int among(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }

 private:
  std::mt19937_64 engine_{31};
};

TEST(ShortInteger, IsThereUpToItsBits) {
  EXPECT_EQ(short_integer_3(0, 31), 0);
  EXPECT_EQ(short_integer_3(-5, 3), -5);
  EXPECT_FALSE(short_integer_3(8, 3));
  const Integer most = (Integer(1) << 62) - 1;
  EXPECT_EQ(short_integer_3(Integer(-most), 62), -((std::int64_t{1} << 62) - 1));
  EXPECT_FALSE(short_integer_3(Integer(most + 1), 62));
  EXPECT_FALSE(short_integer_3(Integer(1) << 64, 62));
}

TEST(PlaneSide, IsThatOfIntegers) {
  Numbers numbers;
  int on = 0;
  for (int k = 0; k < 20000; ++k) {
    const int of_normal = 60 + numbers.among(4), of_vertex = 29 + numbers.among(4);
    const IntegerVector normal = numbers.vector(of_normal), vertex = numbers.vector(of_vertex);
    const Integer weight = abs(numbers.next(29 + numbers.among(4))) + 1;
    IntegerVector point = numbers.vector(60 + numbers.among(4));
    if (k % 2 == 0) {  // near the plane, or on it: along an edge of it, and a little off
      const IntegerVector along = cross(normal, {1, 2, 3}), at = multiple(weight, vertex);
      point = sum(at, {along.x >> 40, along.y >> 40, along.z >> 40});
      if (k % 4 == 0) point = at;
    }
    const int expected = sgn(dot(normal, difference(point, multiple(weight, vertex))));
    on += expected == 0;
    ASSERT_EQ(plane_side_3(normal, point, weight, vertex), expected) << k;
  }
  EXPECT_GT(on, 4000);
}

TEST(IsAtVertex, IsThatOfIntegers) {
  Numbers numbers;
  int at = 0;
  for (int k = 0; k < 20000; ++k) {
    const IntegerVector vertex = numbers.vector(29 + numbers.among(4));
    const Integer weight = abs(numbers.next(29 + numbers.among(4))) + 1;
    IntegerVector point = multiple(weight, vertex);
    if (const int moved = numbers.among(6); moved < 3) *(std::array{&point.x, &point.y, &point.z}[moved]) += 1;
    const bool expected = is_zero(difference(point, multiple(weight, vertex)));
    at += expected;
    ASSERT_EQ(is_at_vertex_3(point, weight, vertex), expected) << k;
  }
  EXPECT_GT(at, 8000);
}

}  // namespace
}  // namespace hottel

#include "geometry/space/scene/coplanar_overlap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

namespace hottel {
namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

// A frame of rational vectors of different lengths: no axis of it is one of the coordinates.
Point3 in_space(const Rational& u, const Rational& v) {
  return {Rational(1) / 3 + 2 * u - v, u + 3 * v, Rational(5) / 7 - u + v / 2};
}

// A rectangle of the plane of in_space; its front on either side.
Polygon3 rectangle(const Rational& u, const Rational& v, const Rational& width, const Rational& height,
                   bool turned = false) {
  Polygon3 result{{in_space(u, v), in_space(u + width, v), in_space(u + width, v + height), in_space(u, v + height)}};
  if (turned) std::reverse(result.points.begin(), result.points.end());
  return result;
}

TEST(FirstOverlap, IsNoneWherePolygonsTouch) {
  EXPECT_EQ(first_overlap({}), std::nullopt);
  const Rational third = Rational(1) / 3;
  EXPECT_EQ(first_overlap({rectangle(0, 0, third, 1), rectangle(third, 0, third, 1), rectangle(2 * third, 0, third, 1),
                           rectangle(0, 1, 1, 1), rectangle(1, 2, 1, 1)}),
            std::nullopt);
}

TEST(FirstOverlap, IsFoundOnWhicheverSideTheFrontsAre) {
  const Rational little = Rational(1) / Integer("1000000000000000000000000000000");
  for (const bool turned : {false, true}) {
    EXPECT_EQ(first_overlap({rectangle(0, 0, 1, 1), rectangle(0, 0, 1, 1, turned)}), Pair(0, 1));
    EXPECT_EQ(first_overlap({rectangle(0, 0, 4, 4), rectangle(1, 1, 1, 1, turned)}), Pair(0, 1));
    EXPECT_EQ(first_overlap({rectangle(1, 1, 1, 1, turned), rectangle(0, 0, 4, 4)}), Pair(0, 1));
    EXPECT_EQ(first_overlap({rectangle(0, 0, 1, 1), rectangle(1 - little, 0, 1, 1, turned)}), Pair(0, 1));
    EXPECT_EQ(first_overlap({rectangle(0, 0, 1, 1), rectangle(1 + little, 0, 1, 1, turned)}), std::nullopt);
  }
}

TEST(FirstOverlap, IsNoneInOtherPlanes) {
  Polygon3 above = rectangle(0, 0, 1, 1);
  for (Point3& p : above.points) p.z += Rational(1) / Integer("1000000000000000000000000000000");
  Polygon3 across{{in_space(0, 0), in_space(1, 1), {9, 9, 9}}};
  EXPECT_EQ(first_overlap({rectangle(0, 0, 1, 1), above, across}), std::nullopt);
}

TEST(FirstOverlap, IsThatOfTheFirstPolygonWithOneBeforeItAndTheFirstOfThose) {
  EXPECT_EQ(first_overlap({rectangle(5, 5, 1, 1), rectangle(0, 0, 2, 2), rectangle(2, 0, 2, 2), rectangle(1, 1, 2, 2),
                           rectangle(5, 5, 1, 1)}),
            Pair(1, 3));
  // Also over planes.
  Polygon3 floor{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, wall{{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}};
  EXPECT_EQ(first_overlap({wall, floor, floor, wall}), Pair(1, 2));
  EXPECT_EQ(first_overlap({floor, wall, wall, floor}), Pair(1, 2));
}

// A second way: cut one convex polygon along the lines of the other's edges, and look at the area of what is left.
using Corner = std::array<Rational, 2>;

Rational area_of(const std::vector<Corner>& p) {
  Rational sum;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const Corner &a = p[k], &b = p[(k + 1) % p.size()];
    sum += a[0] * b[1] - a[1] * b[0];
  }
  return sum;
}

// The part of p left of a -> b.
std::vector<Corner> clipped(const std::vector<Corner>& p, const Corner& a, const Corner& b) {
  const auto height = [&](const Corner& c) -> Rational {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  };
  std::vector<Corner> result;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const Corner &c = p[k], &d = p[(k + 1) % p.size()];
    const Rational hc = height(c), hd = height(d);
    if (hc >= 0) result.push_back(c);
    if (sgn(hc) * sgn(hd) < 0) {
      const Rational t = hc / (hc - hd);
      result.push_back({c[0] + t * (d[0] - c[0]), c[1] + t * (d[1] - c[1])});
    }
  }
  return result;
}

bool share_an_area(const std::vector<Corner>& a, const std::vector<Corner>& b) {
  std::vector<Corner> rest = a;
  for (std::size_t k = 0; k < b.size() && !rest.empty(); ++k) rest = clipped(rest, b[k], b[(k + 1) % b.size()]);
  return area_of(rest) > 0;
}

TEST(FirstOverlap, IsWhatClippingEveryPairFinds) {
  std::mt19937_64 random(3);
  const auto below = [&](unsigned long n) { return Rational(random() % n); };
  int found = 0, none = 0;
  for (int k = 0; k < 2000; ++k) {
    std::vector<std::vector<Corner>> flat;
    std::vector<Polygon3> polygons;
    const Rational side = 5 + below(12);
    while (flat.size() < 2u + static_cast<std::size_t>(k % 4)) {
      std::vector<Corner> corners;
      const Rational u = below(static_cast<unsigned long>(side.get_d())), v = below(9);
      const Rational w = 1 + below(3), h = 1 + below(3);
      if (random() % 2)
        corners = {{u, v}, {u + w, v}, {u + w, v + h}, {u, v + h}};
      else
        corners = {{u, v}, {u + below(4), v + below(2)}, {u + below(3), v + 1 + below(3)}};
      const Rational area = area_of(corners);
      if (area == 0) continue;
      if (area < 0) std::reverse(corners.begin(), corners.end());
      flat.push_back(corners);
      Polygon3 polygon;
      for (const Corner& c : corners) polygon.points.push_back(in_space(c[0], c[1]));
      if (random() % 2) std::reverse(polygon.points.begin(), polygon.points.end());
      polygons.push_back(polygon);
    }
    std::optional<Pair> expected;
    for (std::uint32_t b = 0; b < flat.size() && !expected; ++b)
      for (std::uint32_t a = 0; a < b && !expected; ++a)
        if (share_an_area(flat[a], flat[b])) expected = Pair(a, b);
    ASSERT_EQ(first_overlap(polygons), expected) << k;
    ++(expected ? found : none);
  }
  EXPECT_GT(found, 300);
  EXPECT_GT(none, 300);
}

std::vector<Polygon3> tiles(unsigned long side) {
  std::vector<Polygon3> result;
  const Rational part = Rational(1) / 3;
  for (unsigned long k = 0; k < side * side; ++k)
    result.push_back(rectangle(part * Rational(k % side), part * Rational(k / side), part, part, k % 3 == 0));
  return result;
}

TEST(FirstOverlap, IsFoundAmongTenThousandTiles) {
  std::vector<Polygon3> floor = tiles(100);
  EXPECT_EQ(first_overlap(floor), std::nullopt);
  floor.push_back(rectangle(Rational(50) / 3 + Rational(1) / 9, Rational(7) / 3, Rational(1) / 9, Rational(1) / 9));
  EXPECT_EQ(first_overlap(floor), Pair(750, 10000));
  // The same tile again and again.
  EXPECT_EQ(first_overlap(std::vector<Polygon3>(10000, floor[0])), Pair(0, 1));
}

TEST(FirstOverlap, IsFoundFarBeyondTheRangeOfDoubles) {
  std::vector<Polygon3> floor = tiles(4);
  const Rational far = *parse_rational("1e400");
  for (Polygon3& p : floor)
    for (Point3& q : p.points) q = {q.x * far, q.y * far, q.z * far};
  EXPECT_EQ(first_overlap(floor), std::nullopt);
  floor.push_back(floor[3]);
  EXPECT_EQ(first_overlap(floor), Pair(3, 16));
}

}  // namespace
}  // namespace hottel

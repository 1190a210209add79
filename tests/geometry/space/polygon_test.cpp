#include "geometry/space/scene/polygon.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <vector>

namespace hottel::polygon_test {
namespace {

using ::testing::HasSubstr;

// Points from "x y z, x y z, ..."; numbers as in a scene file.
Polygon3 polygon(const std::string& text) {
  Polygon3 result;
  std::vector<Rational> numbers;
  std::string word;
  for (const char c : text + " ") {
    if (c != ' ' && c != ',') {
      word += c;
    } else if (!word.empty()) {
      numbers.push_back(*parse_rational(word));
      word.clear();
    }
  }
  for (std::size_t k = 0; k + 2 < numbers.size(); k += 3)
    result.points.push_back({numbers[k], numbers[k + 1], numbers[k + 2]});
  return result;
}

std::string problem(const std::string& text) { return polygon_problem(polygon(text)).text; }

// Turned by the rotation of (2, 3, 6) / 7, exactly.
Polygon3 tilted(const Polygon3& flat) {
  Polygon3 result;
  for (const Point3& p : flat.points)
    result.points.push_back(
        {(2 * p.x + 3 * p.y + 6 * p.z) / 7, (6 * p.x + 2 * p.y - 3 * p.z) / 7, (-3 * p.x + 6 * p.y - 2 * p.z) / 7});
  return result;
}

TEST(Polygon3, HasAtLeastThreePointsNotOnOneLine) {
  EXPECT_EQ(problem("0 0 0, 1 0 0"), "has fewer than three points");
  EXPECT_EQ(problem("0 0 0, 1 1 1, 3 3 3"), "has no area: its points lie on one line");
  EXPECT_EQ(problem("0 0 0, 1 0 0, 0 1 0"), "");
}

TEST(Polygon3, HasNoTwoEqualPoints) {
  EXPECT_EQ(problem("0 0 0, 1 0 0, 1 1 0.5, 1/1 1.0 1/2"), "has the point (1, 1, 0.5) twice");
  EXPECT_EQ(problem("0 0 0, 1 0 0, 1 1 0, 0 0 0"), "has the point (0, 0, 0) twice");
  EXPECT_THAT(polygon_problem(polygon("0 0 0, 1 0 0, 1 1 0, 0 0 0")).hint, HasSubstr("do not repeat it"));
  EXPECT_THAT(polygon_problem(polygon("0 0 0, 1 0 0, 1 1 0, 0 0 0, 0 1 0")).hint, HasSubstr("passes each point once"));
}

TEST(Polygon3, HasCoordinatesInLowestTerms) {
  Polygon3 bad = polygon("0 0 0, 1 0 0, 0 1 0");
  bad.points[1].y = Rational(2, 4);
  EXPECT_THAT(polygon_problem(bad).text, HasSubstr("lowest terms"));
}

TEST(Polygon3, LiesInOnePlaneExactly) {
  // Decimals that are not doubles: three tenths three times are nine tenths.
  EXPECT_EQ(problem("0 0 0, 1 0 0.3, 1 1 0.9, 0 1 0.6"), "");
  EXPECT_EQ(problem("0 0 0, 1 0 1/3, 1 1 1, 0 1 2/3"), "");
  EXPECT_EQ(problem("0 0 0, 1 0 1/3, 1 1 1, 0 1 0.66666666666666666667").substr(0, 12), "is not plane");
  // Of the triangle of points 1, 3 and 4, whose normal is (0, 2.5, 110), the first one lies 25 / |normal| off.
  EXPECT_EQ(problem("0 0 0, 5 -1 0.25, 10 0 0, 10 10 0, 0 10 0"),
            "is not plane: points lie 0.22721405353294152 off the plane of three of them");
  EXPECT_THAT(polygon_problem(polygon("0 0 0, 3 0 0, 3 4 0, 0 4 1")).hint, HasSubstr("triangles"));
}

TEST(Polygon3, TellsHowFarPointsAreOffThePlaneOfThreeThatLieFarApart) {
  // The first three points are nearly on one line: their plane would be steep.
  EXPECT_EQ(problem("0 0 0, 5 0.001 0.001, 10 0 0, 10 10 0, 0 10 0"),
            "is not plane: points lie 0.001 off the plane of three of them");
}

TEST(Polygon3, MayHavePointsInTheMiddleOfItsSides) {
  EXPECT_EQ(problem("0 0 0, 1/3 0 0, 1 0 0, 1 1 0, 0.5 1 0, 0 1 0"), "");
  EXPECT_EQ(problem("1/3 0 0, 2/3 0 0, 1 0 0, 1 1 0, 0 1 0, 0 0 0"), "");
}

TEST(Polygon3, IsConvexOnWhicheverSideAndWhereverItBegins) {
  const auto expect = [](Polygon3 p, bool is_one) {
    for (std::size_t begin = 0; begin < p.points.size(); ++begin) {
      for (Polygon3 q : {p, tilted(p)}) {
        EXPECT_EQ(polygon_problem(q).text, "") << begin;
        EXPECT_EQ(is_convex(q), is_one) << begin;
        std::reverse(q.points.begin(), q.points.end());
        EXPECT_EQ(polygon_problem(q).text, "") << begin;
        EXPECT_EQ(is_convex(q), is_one) << begin;
      }
      std::rotate(p.points.begin(), p.points.begin() + 1, p.points.end());
    }
  };
  expect(polygon("0 0 0, 2 0 0, 2 2 0, 1 0.5 0"), false);
  expect(polygon("0 0 0, 2 0 0, 2 1 0, 1 1 0, 1 2 0, 0 2 0"), false);
  expect(polygon("0 0 0, 2 0 0, 3 1 0, 2 3 0, 1 3 0, 0 2 0"), true);
  Polygon3 holed = polygon("0 0 0, 4 0 0, 4 4 0, 0 4 0");
  holed.holes = {polygon("1 1 0, 2 1 0, 2 2 0, 1 2 0").points};
  EXPECT_EQ(polygon_problem(holed).text, "");
  EXPECT_FALSE(is_convex(holed));
}

TEST(Polygon3, DoesNotGoBackOrCrossItself) {
  EXPECT_THAT(problem("0 0 0, 3 0 0, 2 0 0, 2 2 0"), HasSubstr("goes back along itself at the point (3, 0, 0)"));
  EXPECT_EQ(problem("0 0 0, 1 1 0, 1 0 0, 0 1 0"), "crosses itself at the point (0.5, 0.5, 0)");  // of area 0
  // A pentagram turns to one side only.
  EXPECT_THAT(problem("0 3 0, 2 -3 0, -3 1 0, 3 1 0, -2 -3 0"), HasSubstr("crosses itself at the point"));
}

TEST(Polygon3, HasItsHolesInItBesideEachOther) {
  const auto with = [](const std::vector<std::string>& holes) {
    Polygon3 p = polygon("0 0 0, 4 0 0, 4 4 0, 0 4 0");
    for (const std::string& hole : holes) p.holes.push_back(polygon(hole).points);
    return polygon_problem(p).text;
  };
  EXPECT_EQ(with({"1 1 0, 2 1 0, 2 2 0, 1 2 0"}), "");
  EXPECT_EQ(with({"1 1 0, 1 2 0, 2 2 0, 2 1 0"}), "");                                // in either sense
  EXPECT_EQ(with({"0 0 0, 1 0 0, 1 1 0", "1 1 0, 2 1 0, 2 2 0"}), "");                // touching
  EXPECT_EQ(with({"3 3 0, 5 3 0, 5 5 0"}), "crosses itself at the point (4, 3, 0)");  // half outside
  EXPECT_THAT(with({"5 5 0, 6 5 0, 6 6 0"}), HasSubstr("holes that are not in it"));
  EXPECT_THAT(with({"1 1 0, 3 1 0, 3 3 0, 1 3 0", "2 2 0, 5/2 2 0, 5/2 5/2 0"}), HasSubstr("share an area"));
  EXPECT_THAT(with({"1 1 0, 2 1 0, 2 2 0", "1 1 0, 2 1 0, 2 2 0"}), HasSubstr("share an area"));
  EXPECT_THAT(with({"1 1 1, 2 1 1, 2 2 1"}), HasSubstr("is not plane"));
  EXPECT_THAT(with({"1 1 0, 2 2 0, 3 3 0"}), HasSubstr("has a hole without an area"));
  EXPECT_THAT(with({"1 1 0, 2 2 0"}), HasSubstr("has a hole that has fewer than three points"));
}

TEST(Polygon3, HasTheNormalOfItsFrontTwiceAsLongAsItsArea) {
  const Polygon3 square = polygon("5 5 1, 7 5 1, 7 8 1, 5 8 1");
  EXPECT_EQ(doubled_area(square), (Vector3{0, 0, 12}));
  Polygon3 back = square;
  std::reverse(back.points.begin(), back.points.end());
  EXPECT_EQ(doubled_area(back), (Vector3{0, 0, -12}));
  Polygon3 other = tilted(square);
  const Vector3 normal = doubled_area(other);
  EXPECT_EQ(dot(normal, normal), 144);
  std::rotate(other.points.begin(), other.points.begin() + 2, other.points.end());
  EXPECT_EQ(doubled_area(other), normal);
}

// Convex hulls of random points of a small grid have no problem; with two points swapped they have one.
TEST(Polygon3, OfAHullHasNoProblemAndWithTwoPointsSwappedOne) {
  std::mt19937_64 random(20241);
  int tested = 0;
  for (int k = 0; k < 300; ++k) {
    std::vector<std::array<long, 2>> points;
    for (int i = 0; i < 12; ++i) points.push_back({static_cast<long>(random() % 7), static_cast<long>(random() % 7)});
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    std::vector<std::array<long, 2>> hull;
    for (int side = 0; side < 2; ++side) {
      const std::size_t start = hull.size();
      for (const auto& p : points) {
        const auto turns_right = [&] {
          const auto &a = hull[hull.size() - 2], &b = hull.back();
          return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) <= 0;
        };
        while (hull.size() >= start + 2 && turns_right()) hull.pop_back();
        hull.push_back(p);
      }
      hull.pop_back();
      std::reverse(points.begin(), points.end());
    }
    if (hull.size() < 5) continue;
    Polygon3 flat;
    for (const auto& p : hull) flat.points.push_back({p[0], p[1], p[0] + 2 * p[1]});
    EXPECT_EQ(polygon_problem(flat).text, "");
    std::swap(flat.points[1], flat.points[3]);
    EXPECT_NE(polygon_problem(flat).text, "");
    ++tested;
  }
  EXPECT_GT(tested, 100);
}

}  // namespace
}  // namespace hottel::polygon_test

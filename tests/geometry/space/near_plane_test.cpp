#include "geometry/space/scene/near_plane.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <random>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "geometry/planarity.h"
#include "geometry/space/scene/bent_loops.h"
#include "geometry/space/scene/facet_scene.h"

namespace hottel::near_plane_test {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;
using ::testing::StartsWith;

Rational q(const char* text) { return *parse_rational(text); }

Rational unit_of(std::initializer_list<std::string_view> numbers) {
  FinestDigit finest;
  for (const std::string_view number : numbers) finest.take(number);
  return finest.unit();
}

TEST(FinestDigit, IsThatOfTheNumberWithTheMostDecimals) {
  EXPECT_EQ(unit_of({}), 0);
  EXPECT_EQ(unit_of({"1/3", "-7/1000"}), 0);
  EXPECT_EQ(unit_of({"1/3", "12"}), 1);
  EXPECT_EQ(unit_of({"12", "0.5", "1.25", "3"}), q("1/100"));
  EXPECT_EQ(unit_of({"1.50"}), q("1/100"));
  EXPECT_EQ(unit_of({"1.5e-3"}), q("1/10000"));
  EXPECT_EQ(unit_of({"2E3"}), 1000);
  EXPECT_EQ(unit_of({"2.5e1", "-1e+2"}), 1);
  EXPECT_EQ(unit_of({".5"}), q("1/10"));
}

TEST(FloatSpacing, IsThatOfTheLargestCoordinate) {
  for (const auto& [value, digits] :
       {std::tuple(1.0, 53), std::tuple(1.999, 53), std::tuple(-1e30, 53), std::tuple(0x1p-90, 53)}) {
    const double next = std::nextafter(std::fabs(value), INFINITY);
    EXPECT_EQ(float_spacing({{{0, 0, 0}, {Rational(value), 0, 1e-99}, {0, 1e-99, 0}}}, digits),
              Rational(next) - Rational(std::fabs(value)));
  }
  const float value = 0.7F;
  EXPECT_EQ(float_spacing({{{0, Rational(value), 0}, {0, 0, 0}, {0, 0, q("1/8")}}}, 24),
            Rational(std::nextafter(value, 1.0F)) - Rational(value));
  EXPECT_EQ(float_spacing({{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}}, 24), 0);
}

// A square of this side with one corner lifted.
Polygon3 lifted(const Rational& side, const Rational& lift) {
  return {{{0, 0, 0}, {side, 0, 0}, {side, side, 0}, {0, side, lift}}};
}

// How far it is off being plane, squared.
Rational off(const Rational& side, const Rational& lift) { return bend_of(lifted(side, lift).points).squared_distance; }

bool is_accepted(Polygon3 polygon, const Rational& unit) {
  const bool result = accept_nearly_plane(polygon, unit);
  EXPECT_EQ(polygon.is_nearly_plane, result);
  if (result) {
    EXPECT_EQ(polygon_problem(polygon).text, "");
  }
  return result;
}

TEST(BendOf, IsOffThePlaneOfTheLargestTriangle) {
  EXPECT_EQ(off(1, 0), 0);
  const Rational lift = q("1/10");
  // Triangles 0 1 3 and 1 2 3 have the area sqrt(1 + lift^2) / 2, and 0 2 3 has sqrt(1 + 2 lift^2) / 2, the largest.
  // Its normal is (lift, -lift, 1), and corner 1 lies lift / |normal| off it.
  EXPECT_EQ(off(1, lift), lift * lift / (1 + 2 * lift * lift));
  EXPECT_EQ(bend_of(lifted(1, lift).points).farthest, (Point3{1, 0, 0}));
  EXPECT_EQ(bend_of(lifted(1, lift).points).squared_diameter, 2 + lift * lift);
  // Ties: of a saddle all four triangles are equal, and the first is that of corners 0, 1 and 2.
  const std::vector<Point3> saddle{{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}};
  EXPECT_EQ(bend_of(saddle).farthest, (Point3{0, 1, 1}));
}

// Every triangle, by exact arithmetic.
TEST(BendOf, AgreesWithAllTriangles) {
  std::mt19937 random(3);
  const auto coordinate = [&] { return Rational(static_cast<long>(random() % 9) - 4, 1 + random() % 3); };
  for (int round = 0; round < 200; ++round) {
    std::vector<Point3> points;
    for (unsigned k = 0; k < 4 + random() % 5; ++k) points.push_back({coordinate(), coordinate(), coordinate()});
    for (Point3& p : points)
      for (Rational* c : {&p.x, &p.y, &p.z}) c->canonicalize();
    Rational most = 0, distance = 0;
    for (std::size_t a = 0; a < points.size(); ++a)
      for (std::size_t b = a + 1; b < points.size(); ++b)
        for (std::size_t c = b + 1; c < points.size(); ++c) {
          const Vector3 normal = cross(points[b] - points[a], points[c] - points[a]);
          if (dot(normal, normal) <= most) continue;
          most = dot(normal, normal);
          distance = 0;
          for (const Point3& p : points) {
            const Rational height = dot(normal, p - points[a]);
            distance = std::max(distance, Rational(height * height / most));
          }
        }
    EXPECT_EQ(bend_of(points).squared_distance, distance) << round;
  }
}

// (1) by at most four units of the last digit; (2) of which a ten thousandth of the diameter is the most.
TEST(NearlyPlane, FourUnitsOfTheLastDigitAreAccepted) {
  const Rational unit = q("1/1000000");
  // The lifted corner is the lift over sqrt(1 + 2 lift^2) off: less than the lift.
  EXPECT_TRUE(is_accepted(lifted(1, 4 * unit), unit));
  EXPECT_TRUE(is_accepted(lifted(1, -4 * unit), unit));
  EXPECT_FALSE(is_accepted(lifted(1, q("4.001") * unit), unit));
  EXPECT_FALSE(is_accepted(lifted(1, 4 * unit), unit / 10));
  EXPECT_FALSE(is_accepted(lifted(1, 0), unit)) << "it is plane";
  EXPECT_FALSE(is_accepted({{{0, 0, 0}, {1, 0, 0}, {0, 1, 1}}}, unit)) << "so is a triangle";
  // The diameter is sqrt(2) and a little.
  EXPECT_TRUE(is_accepted(lifted(1, q("0.000141")), q("0.001")));
  EXPECT_FALSE(is_accepted(lifted(1, q("0.000142")), q("0.001")));
}

TEST(NearlyPlane, RoundingOfDoublesIsAcceptedWithoutDigits) {
  const Rational part = scaled_by_power_of_two(1, -40);
  EXPECT_TRUE(is_accepted(lifted(1, q("1.414") * part), 0));
  EXPECT_FALSE(is_accepted(lifted(1, q("1.415") * part), 0));
  EXPECT_TRUE(is_accepted(lifted(q("1e30"), q("1.414e30") * part), 0));
}

TEST(NearlyPlane, WhatCannotBeCutIsNot) {
  const Rational h = q("1e-7"), unit = q("1e-7");
  EXPECT_FALSE(is_accepted({{{0, 0, 0}, {1, 1, h}, {1, 0, 0}, {0, 2, 0}}}, unit)) << "crosses itself";
  EXPECT_FALSE(is_accepted({{{0, 0, 0}, {1, 0, h}, {1, 1, 0}, {0, 0, 0}, {0, 1, 0}}}, unit)) << "has a point twice";
  Polygon3 crossed{{{0, 0, 0}, {1, 1, h}, {1, 0, 0}, {0, 2, 0}}};
  crossed.is_nearly_plane = true;
  EXPECT_THAT(polygon_problem(crossed).text, StartsWith("is not plane, and cannot be cut into triangles"));
}

TEST(NearlyPlane, FacetsAreTrianglesOfTheFirstCornerOrWithHolesAsSeen) {
  const Rational h = q("1e-7");
  Polygon3 quad = lifted(1, h);
  ASSERT_TRUE(accept_nearly_plane(quad, h));
  const auto facets = facets_of(quad);
  ASSERT_THAT(facets, SizeIs(2));
  EXPECT_THAT(facets[0].points, ElementsAre(quad.points[0], quad.points[1], quad.points[2]));
  EXPECT_THAT(facets[1].points, ElementsAre(quad.points[0], quad.points[2], quad.points[3]));
  EXPECT_FALSE(is_convex(quad));
  EXPECT_TRUE(contains(quad, {q("1/2"), q("1/4"), 0}));
  EXPECT_FALSE(contains(quad, {q("1/4"), q("1/2"), 0})) << "below it";
  EXPECT_TRUE(contains(quad, {q("1/4"), q("1/2"), h / 4}));

  Polygon3 door = lifted(4, h);
  door.holes = {{{1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, h}}};
  ASSERT_TRUE(accept_nearly_plane(door, h));
  const auto pieces = facets_of(door);
  ASSERT_THAT(pieces, SizeIs(8));
  Rational area;
  for (const Polygon3& piece : pieces) area += doubled_area(piece).z;
  EXPECT_EQ(area, 2 * (16 - 1));
  door.holes[0][0] = {-1, 1, 0};
  EXPECT_FALSE(accept_nearly_plane(door, h)) << "the hole is not in it";
}

TEST(FacetScene3, HasTheFacetsInPlaceOfThePolygons) {
  Scene3 scene;
  scene.materials.emplace_back();
  for (const char* name : {"a", "b", "c"}) {
    scene.groups.emplace_back(name);
    Surface surface;
    surface.name = name;
    surface.group = static_cast<std::uint32_t>(scene.groups.size() - 1);
    scene.add(surface, lifted(1, 0));
  }
  EXPECT_FALSE(facet_scene(scene).has_value());
  scene.polygons[1] = lifted(1, q("1e-20"));
  ASSERT_TRUE(accept_nearly_plane(scene.polygons[1], 0));
  const auto facets = facet_scene(scene);
  ASSERT_TRUE(facets.has_value());
  EXPECT_THAT(facets->surface_of, ElementsAre(0u, 1u, 1u, 2u));
  EXPECT_EQ(facets->scene.surfaces[2], scene.surfaces[1]);
  EXPECT_EQ(facets->scene.polygons[3], scene.polygons[2]);
  EXPECT_THAT(facets->scene.polygons[2].points, SizeIs(3));
}

}  // namespace
}  // namespace hottel::near_plane_test

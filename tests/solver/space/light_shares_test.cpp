// Where the power of lights goes first: closed forms, borders of beams, elements, the sky, solids.
#include "solver/space/light/light_shares.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "tests/comparison/space/map_comparison.h"
#include "tests/geometry/space/box_scene.h"
#include "tests/oracle/space/nearest_polygon.h"
#include "tests/oracle/space/random_polygons.h"

namespace hottel::light_shares_test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kTiny = 4e-16;

struct Lit {
  ElementTable3 table;
  LightShares3 shares;

  const LightShare3& of(const std::string& name) const {
    for (std::uint32_t k = 0; k < table.count(); ++k)
      if (table.elements()[k].name == name) return shares.elements[k];
    ADD_FAILURE() << name;
    return shares.sky;
  }
  double at(const std::string& name) const { return of(name).value; }
};

Lit light(const Scene3& scene, const Point3& position, const Beam3& beam,
          Granularity granularity = Granularity::kFace) {
  const PreparedScene3 prepared = prepare(scene);
  ElementTable3 table = *prepared.elements(granularity);
  LightShares3 shares = light_shares(prepared, table, position, beam);
  double sum = shares.sky.value + shares.lost.value, lower = shares.sky.bounds.lower + shares.lost.bounds.lower,
         upper = shares.sky.bounds.upper + shares.lost.bounds.upper;
  for (const LightShare3& share : shares.elements) {
    EXPECT_TRUE(share.bounds.contains(share.value));
    EXPECT_LE(share.bounds.width(), 0x1p-49 * share.value);
    sum += share.value;
    lower += share.bounds.lower;
    upper += share.bounds.upper;
  }
  EXPECT_NEAR(sum, 1, 1e-13);
  EXPECT_LE(lower, 1 + 1e-15);
  EXPECT_GE(upper, 1 - 1e-15);
  return {std::move(table), std::move(shares)};
}

Scene3 room(std::uint32_t elements = 1) {
  BoxScene3 scene;
  scene.box("room", {-1, -1, -1}, {1, 1, 1}, true);
  for (Surface& surface : scene.surfaces) surface.elements = elements;
  return scene;
}

// A square of side 2 in z = 1, its front down.
Scene3 square(const Rational& half = 1) {
  BoxScene3 scene;
  scene.polygon("square", {{{-half, -half, 1}, {-half, half, 1}, {half, half, 1}, {half, -half, 1}}, {}});
  return scene;
}

const Point3 kOrigin{0, 0, 0};

TEST(LightShares3, AWallOfACubeGetsASixthFromItsMiddle) {
  const Lit lit = light(room(), kOrigin, {});
  for (const char* name : {"bottom", "top", "south", "north", "west", "east"})
    EXPECT_NEAR(lit.at("room " + std::string(name)), 1.0 / 6, kTiny) << name;
  EXPECT_EQ(lit.shares.sky.value, 0);
  EXPECT_LE(lit.shares.sky.bounds.upper, 0x1p-90);
}

TEST(LightShares3, FrontsAndBacksAreMetFromTheirSides) {
  const Lit below = light(square(), kOrigin, {});
  EXPECT_NEAR(below.at("square"), 1.0 / 6, kTiny);
  EXPECT_EQ(below.at("square:back"), 0);
  EXPECT_NEAR(below.shares.sky.value, 5.0 / 6, kTiny);
  const Lit above = light(square(), {0, 0, 2}, {});
  EXPECT_NEAR(above.at("square:back"), 1.0 / 6, kTiny);
  EXPECT_EQ(above.of("square"), LightShare3{});
}

// The beam is in the inscribed circle: tan f < 1.
TEST(LightShares3, ABeamWithinAFaceGivesAllToIt) {
  for (const Rational& falloff : {Rational(0), Rational(1), Rational(2), Rational(5, 2)})
    for (const Rational& f : {Rational(1, 1000), Rational(20), Rational(44), Rational(45)}) {
      const Lit lit = light(square(), kOrigin, {{0, 0, 3}, f, falloff});
      EXPECT_EQ(lit.at("square"), 1) << f << " " << falloff;
      EXPECT_EQ(lit.shares.sky.value, 0) << f << " " << falloff;
    }
}

// The circle through the corners of the square: tan^2 f = 2.
TEST(LightShares3, OfAWiderBeamWhatIsBesideTheFaceGoesToTheSky) {
  const Lit lit = light(square(), kOrigin, {{0, 0, 1}, 60, 0});
  EXPECT_NEAR(lit.at("square"), (4 * kPi / 6) / (2 * kPi * 0.5), kTiny);
}

// Half of the directions of a face of the cube around its middle, by Lambert: the view factor from a point, over 1.
TEST(LightShares3, AFalloffOfOneIsLamberts) {
  const Lit lit = light(square(), kOrigin, {{0, 0, 1}, 90, 1});
  const double expected = 4 / kPi * std::sqrt(0.5) * std::atan(std::sqrt(0.5)) * 1;
  EXPECT_NEAR(lit.at("square"), expected, kTiny);
}

TEST(LightShares3, AFaceInWhosePlaneTheLightIsGetsNothing) {
  const Lit lit = light(square(), {5, 0, 1}, {});
  EXPECT_EQ(lit.at("square"), 0);
  EXPECT_EQ(lit.at("square:back"), 0);
  EXPECT_EQ(lit.shares.sky.value, 1);
}

TEST(LightShares3, ABeamThatTouchesAFaceGivesItNothing) {
  // The axis goes up, the face stands with its lower edge on the border of the beam of 45 degrees: z = x.
  BoxScene3 scene;
  scene.polygon("wall", {{{1, -1, 1}, {1, 1, 1}, {1, 1, 0}, {1, -1, 0}}, {}});
  const Lit lit = light(scene, kOrigin, {{0, 0, 1}, 45, 0});
  EXPECT_EQ(lit.of("wall"), LightShare3{});
  EXPECT_EQ(lit.of("wall:back"), LightShare3{});
  const Lit wider = light(scene, kOrigin, {{0, 0, 1}, Rational(45) + Rational(1, 1'000'000), 0});
  EXPECT_GT(wider.at("wall") + wider.at("wall:back"), 0);
  EXPECT_LT(wider.at("wall") + wider.at("wall:back"), 1e-9);
}

TEST(LightShares3, ElementsShareWhatTheirFaceGets) {
  const std::vector<Beam3> beams{
      {}, {{1, 2, 3}, 50, 0}, {{1, 2, 3}, 50, 2}, {{1, 2, 3}, 90, Rational(5, 2)}, {{1, 2, 3}, 130, 0}};
  for (const Beam3& beam : beams) {
    const Point3 position{Rational(1, 3), Rational(1, 7), Rational(-2, 5)};
    const Lit faces = light(room(), position, beam);
    const Lit elements = light(room(3), position, beam, Granularity::kElement);
    for (std::uint32_t k = 0; k < faces.table.count(); ++k) {
      double sum = 0;
      for (std::uint32_t e = 0; e < elements.table.count(); ++e) {
        const Element& element = elements.table.elements()[e];
        const Element& face = faces.table.elements()[k];
        if (element.surface == face.surface && element.is_back == face.is_back)
          sum += elements.shares.elements[e].value;
      }
      EXPECT_NEAR(sum, faces.shares.elements[k].value, 1e-15);
    }
  }
}

// Nine squares in the order of elements: from the first vertex, along the first side first.
TEST(LightShares3, AnElementGetsWhatAPolygonInItsPlaceGets) {
  Scene3 divided = square();
  divided.surfaces[0].elements = 3;
  BoxScene3 tiles;
  for (int k = 0; k < 9; ++k) {
    const Rational x0 = -1 + Rational(2 * (k / 3)) / 3, x1 = x0 + Rational(2, 3);
    const Rational y0 = -1 + Rational(2 * (k % 3)) / 3, y1 = y0 + Rational(2, 3);
    tiles.polygon("tile" + std::to_string(k), {{{x0, y0, 1}, {x0, y1, 1}, {x1, y1, 1}, {x1, y0, 1}}, {}});
  }
  const Point3 position{Rational(1, 5), Rational(1, 9), Rational(1, 2)};
  for (const Beam3& beam : {Beam3{}, Beam3{{1, 2, 3}, 50, 0}, Beam3{{1, 2, 3}, 90, Rational(5, 2)}}) {
    const Lit elements = light(divided, position, beam, Granularity::kElement), polygons = light(tiles, position, beam);
    for (int k = 0; k < 9; ++k)
      EXPECT_DOUBLE_EQ(elements.at("square#" + std::to_string(k)), polygons.at("tile" + std::to_string(k))) << k;
  }
}

TEST(LightShares3, InASolidAllIsLost) {
  BoxScene3 scene;
  scene.box("box", {-1, -1, -1}, {1, 1, 1});
  const Lit lit = light(scene, kOrigin, {});
  EXPECT_TRUE(lit.shares.is_in_solid);
  EXPECT_EQ(lit.shares.lost.value, 1);
  EXPECT_EQ(lit.shares.sky.value, 0);
}

// What a square of side 2 gets of a point at the height h: asin(1 / (1 + h^2)) / pi of all directions, atan(1 / (h
// sqrt(2 + h^2))) / pi.
TEST(LightShares3, ALightMayBeAsNearToAFaceAsItLikes) {
  for (const int k : {1, 10, 30, 100, 400}) {
    const Rational height = Rational(1) / Rational(Integer(1) << k);
    const double h = std::ldexp(1.0, -k);
    const Lit lit = light(square(), {0, 0, 1 - height}, {});
    EXPECT_NEAR(lit.at("square"), std::atan(1 / (h * std::sqrt(2 + h * h))) / kPi, 1e-15) << k;
    const Lit beam = light(square(), {Rational(1, 3), Rational(1, 7), 1 - height}, {{0, 0, 1}, 89, Rational(1, 2)});
    EXPECT_GT(beam.at("square"), 0.7) << k;
    const Lit away = light(square(), {0, 0, 1 - height}, {{0, 0, -1}, 90, Rational(1, 2)});
    EXPECT_EQ(away.of("square"), LightShare3{}) << k;
  }
}

TEST(LightShares3, DoNotDependOnPlaceOrUnit) {
  const Beam3 beam{{1, 2, 3}, 50, Rational(5, 2)};
  const auto moved = [&beam](const Rational& scale, const Point3& by) {
    const auto at = [&](long x, long y, long z) {
      return Point3{by.x + scale * x, by.y + scale * y, by.z + scale * z};
    };
    BoxScene3 scene;
    const Point3 a = at(-1, -1, -1), b = at(1, 1, 1);
    scene.box("room", {a.x, a.y, a.z}, {b.x, b.y, b.z}, true);
    scene.polygon("plate", {{at(0, 0, 0), at(1, 0, 0), at(1, 1, 1), at(0, 1, 1)}, {}});
    const Rational third = scale / 3;
    return light(scene, {by.x + third, by.y + third, by.z - third}, beam).shares;
  };
  const LightShares3 first = moved(1, {0, 0, 0}), other = moved(Rational(7, 10), {Rational(1, 3), 1'000'000'000, -5});
  EXPECT_EQ(first.elements, other.elements);
  EXPECT_EQ(first.sky, other.sky);
}

// What is behind the plate of what a beam lights goes to the plate.
TEST(LightShares3, WhatIsHiddenGetsNothing) {
  BoxScene3 scene;
  scene.box("room", {-2, -2, -2}, {2, 2, 2}, true);
  scene.polygon("plate", level(-1, -1, 1, 1, 1));
  const Lit lit = light(scene, kOrigin, {{0, 0, 1}, 45, Rational(1, 3)});
  EXPECT_EQ(lit.at("plate:back"), 1);
  EXPECT_EQ(lit.of("room top"), LightShare3{});
  const Lit wider = light(scene, kOrigin, {{0, 0, 1}, 54, 0});
  const Lit alone = light(square(), kOrigin, {{0, 0, 1}, 54, 0});
  EXPECT_DOUBLE_EQ(wider.at("plate:back"), alone.at("square"));
  double walls = 0;
  for (const char* name : {"top", "south", "north", "west", "east"}) walls += wider.at("room " + std::string(name));
  EXPECT_NEAR(walls, 1 - alone.at("square"), kTiny);
}

// Directions drawn as the beam sends them, followed by the brute force.
TEST(LightShares3, AgreeWithRaysDrawnByChance) {
  const auto polygons = oracle::lattice_room(4, 2, 1, 1, 1);
  BoxScene3 scene;
  for (const Polygon3& polygon : oracle::engine_polygons(polygons))
    scene.polygon("p" + std::to_string(scene.surfaces.size()), polygon, 0, 0);
  const Point3 eye{Rational(17, 4), Rational(9, 2), Rational(39, 8)};
  const oracle::RayCaster caster(polygons, {eye.x, eye.y, eye.z});
  std::mt19937_64 engine(6);
  for (const Beam3& beam : {Beam3{}, Beam3{{-1, 2, -2}, 70, 0}, Beam3{{2, 1, -2}, 90, Rational(3, 2)}}) {
    const Lit lit = light(scene, eye, beam);
    const double n = to_double(beam.falloff), f = to_double(beam.reach()) * kPi / 180;
    const Direction3 axis = unit(Direction3{to_double(beam.axis.x), to_double(beam.axis.y), to_double(beam.axis.z)});
    const Direction3 u = unit(cross(axis, std::fabs(axis.x) < 0.8 ? Direction3{1, 0, 0} : Direction3{0, 1, 0})),
                     v = cross(axis, u);
    constexpr int kRays = 3000;
    std::vector<int> hits(polygons.size());
    for (int k = 0; k < kRays; ++k) {
      const auto chance = [&engine] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
      const double least = n == 0 ? std::cos(f) : std::pow(std::max(0.0, std::cos(f)), n + 1), drawn = chance();
      const double c = n == 0 ? 1 - drawn * (1 - least) : std::pow(1 - drawn * (1 - least), 1 / (n + 1));
      const double around = 2 * kPi * chance(), s = std::sqrt(1 - c * c);
      const Direction3 w = c * axis + s * std::cos(around) * u + s * std::sin(around) * v;
      if (const int hit = caster({w.x, w.y, w.z}).polygon; hit >= 0) ++hits[static_cast<std::size_t>(hit)];
    }
    for (std::size_t p = 0; p < polygons.size(); ++p) {
      const auto surface = static_cast<std::uint32_t>(p);
      const double share = lit.shares.elements[2 * surface].value + lit.shares.elements[2 * surface + 1].value;
      EXPECT_NEAR(hits[p] / static_cast<double>(kRays), share, 4.5 * std::sqrt(share / kRays) + 1e-3) << p;
    }
  }
}

}  // namespace
}  // namespace hottel::light_shares_test

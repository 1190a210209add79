// Where the power of lights goes first: closed forms, borders of beams, elements, the sky, solids.
#include "solver/space/light/light_shares.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "geometry/space/exchange/element_table.h"
#include "geometry/space/exchange/prepared_scene.h"
#include "tests/geometry/space/box_scene.h"

namespace hottel {
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
  ElementTable3 table(prepared.scene, prepared.arrangement(), prepared.blockers(), granularity);
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
  EXPECT_LT(lit.shares.sky.bounds.upper, 1e-30);
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

TEST(LightShares3, InASolidAllIsLost) {
  BoxScene3 scene;
  scene.box("box", {-1, -1, -1}, {1, 1, 1});
  const Lit lit = light(scene, kOrigin, {});
  EXPECT_TRUE(lit.shares.is_in_solid);
  EXPECT_EQ(lit.shares.lost.value, 1);
  EXPECT_EQ(lit.shares.sky.value, 0);
}

}  // namespace
}  // namespace hottel

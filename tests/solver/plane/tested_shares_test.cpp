// Shares of lights by centroids and by vertices: closed forms, borders of beams and shadows, a slow oracle.
#include "solver/plane/light/tested_shares.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "kernel/support/failure.h"
#include "solver/plane/check/scene_check.h"
#include "solver/plane/light/light_shares.h"
#include "solver/plane/simulation/simulation.h"
#include "solver/radiosity/radiosity_solver.h"
#include "tests/solver/plane/lit_scenes.h"

namespace hottel::tested_shares_test {
namespace {

constexpr double kPi = std::numbers::pi;
const Rational kHalf(1, 2);

Light bulb() {
  Light light;
  light.name = "bulb";
  light.power = Spectrum::scalar(1);
  return light;
}

Light spot(const Rational& focus, const Rational& falloff = 0) {
  Light light = bulb();
  light.type = LightType::kSpot;
  light.focus = focus;
  light.falloff = falloff;
  return light;
}

LightShares shares_in(Scene2 scene, const Light& light, const LightPlace2& place, LightTest test) {
  scene.add_light(light, place);
  validate(scene);
  return light_shares(prepare(std::move(scene), Divided2::kYes), Granularity::kElement, test).front();
}

double share(const LightShares& shares, std::size_t element) {
  EXPECT_EQ(shares.of_element[element].lower, shares.of_element[element].upper);
  return shares.of_element[element].lower;
}

double sum_of(const LightShares& shares) {
  double sum = shares.sky.upper;
  for (const Enclosure& each : shares.of_element) sum += each.upper;
  return sum;
}

constexpr LightTest kTests[] = {LightTest::kCentroid, LightTest::kVertices};

// (1): A I / r with I = 1 / (2 pi), A = 1, r = 1/2; together 4 / pi of the power, and nothing less.
TEST(TestedShares2, TakeTheValueAtTheCentroidForAllOfTheElement) {
  for (const LightTest test : kTests) {
    const LightShares shares = shares_in(square_room(), bulb(), {{kHalf, kHalf}}, test);
    EXPECT_EQ(shares.test, test);
    for (std::size_t wall = 0; wall < 4; ++wall) EXPECT_NEAR(share(shares, 2 * wall), 1 / kPi, 1e-15);
    for (std::size_t wall = 0; wall < 4; ++wall) EXPECT_EQ(share(shares, 2 * wall + 1), 0) << "backs";
    EXPECT_EQ(shares.sky, (Enclosure{0, 0}));
    EXPECT_NEAR(sum_of(shares), 4 / kPi, 1e-15);
  }
}

TEST(TestedShares2, OfExactAreThoseOfLightShares) {
  Scene2 scene = pillar_room();
  scene.add_light(spot(50, 2), {{Rational(1, 5), Rational(1, 3)}, {2, 1}});
  const PreparedScene2 prepared = prepare(scene, Divided2::kYes);
  const LightShares exact = light_shares(prepared, Granularity::kElement, LightTest::kExact).front();
  EXPECT_EQ(exact.of_element, light_shares(prepared, Granularity::kElement).front().of_element);
  EXPECT_EQ(exact.test, LightTest::kExact);
}

// The corners of the right wall are at 45 degrees, exactly.
TEST(TestedShares2, BorderOfABeamIsInIt) {
  const LightPlace2 place{{kHalf, kHalf}, {1, 0}};
  const Rational tiny("1/1000000000000000000000000000000");
  const double intensity = 2 / kPi;  // P / 2 f
  EXPECT_NEAR(share(shares_in(square_room(), spot(45), place, LightTest::kVertices), 4), 2 * intensity, 1e-14);
  EXPECT_EQ(share(shares_in(square_room(), spot(45 - tiny), place, LightTest::kVertices), 4), 0);
  EXPECT_NEAR(share(shares_in(square_room(), spot(45 - tiny), place, LightTest::kCentroid), 4), 2 * intensity, 1e-14);
  // The other walls: one vertex each is on the border, their centroids are beyond; 90 degrees away.
  EXPECT_NEAR(share(shares_in(square_room(), spot(45), place, LightTest::kVertices), 2), intensity, 1e-14);
  EXPECT_EQ(share(shares_in(square_room(), spot(45), place, LightTest::kCentroid), 2), 0);
  // cos^n does not reach them.
  for (const Rational& falloff : {Rational(1), Rational(1, 1000)}) {
    EXPECT_EQ(share(shares_in(square_room(), spot(45, falloff), place, LightTest::kVertices), 2), 0);
    const LightPlace2 turned{.position = {kHalf, kHalf}, .direction = {0, -1}, .turned = 90};
    EXPECT_EQ(share(shares_in(square_room(), spot(45, falloff), turned, LightTest::kVertices), 2), 0);
  }
}

// The centroid of the upper half of the right wall is beyond the beam, its lower vertex in it.
TEST(TestedShares2, VerticesWeighTheIntensityWithoutItsCut) {
  Scene2 scene;
  add_polygon(scene, {{0, 0}, {0, 1}, {1, 1}, {1, kHalf}, {1, 0}});
  const LightPlace2 place{{kHalf, kHalf}, {1, 0}};
  const double c = 2 / std::sqrt(5), r = std::sqrt(5) / 4;  // of the centroid (1, 3/4)
  const double peak = 1 / (2 * std::sin(kPi / 9));          // n = 1, f = 20
  EXPECT_NEAR(share(shares_in(scene, spot(20, 1), place, LightTest::kVertices), 4), 0.5 * peak * c * c * 0.5 / r,
              1e-15);
  EXPECT_EQ(share(shares_in(scene, spot(20, 1), place, LightTest::kCentroid), 4), 0);
}

TEST(TestedShares2, LightInTheLineOfAnElementOrBehindItGivesNothing) {
  Scene2 scene = square_room();
  add_edge(scene, {Rational(3, 4), kHalf}, {Rational(7, 8), kHalf}, true);
  for (const LightTest test : kTests) {
    const LightShares shares = shares_in(scene, bulb(), {{kHalf, kHalf}}, test);
    EXPECT_EQ(share(shares, 8), 0);
    EXPECT_EQ(share(shares, 9), 0);
    EXPECT_GT(share(shares_in(scene, bulb(), {{kHalf, Rational(3, 4)}}, test), 9), 0);
    EXPECT_EQ(share(shares_in(scene, bulb(), {{kHalf, Rational(3, 4)}}, test), 8), 0);
  }
}

// (1): what only touches the way to a point hides nothing; a tiny bit more does.
TEST(TestedShares2, TouchedCornerDoesNotHide) {
  const Rational tiny("1/1000000000000000000000000000000");
  const auto wall_behind = [&](const Rational& tip, LightTest test) {
    Scene2 scene = square_room();
    add_edge(scene, {Rational(3, 4), 0}, {Rational(3, 4), tip}, true);
    return share(shares_in(scene, bulb(), {{kHalf, kHalf}}, test), 4);
  };
  EXPECT_NEAR(wall_behind(kHalf, LightTest::kCentroid), 1 / kPi, 1e-15);
  EXPECT_EQ(wall_behind(kHalf + tiny, LightTest::kCentroid), 0);
  // The lower corner of the wall is seen past the tip at 1/4.
  EXPECT_NEAR(wall_behind(Rational(1, 4), LightTest::kVertices), 1 / kPi, 1e-15);
  EXPECT_NEAR(wall_behind(Rational(1, 4) + tiny, LightTest::kVertices), 0.5 / kPi, 1e-15);
}

// (4)
TEST(TestedShares2, ShareOfTheSkyIsExact) {
  Scene2 scene = square_room();
  for (const LightTest test : kTests) {
    const LightShares shares = shares_in(scene, bulb(), {{kHalf, 2}}, test);
    EXPECT_EQ(shares.sky, shares_in(scene, bulb(), {{kHalf, 2}}, LightTest::kExact).sky);
    EXPECT_NEAR(share(shares, 3), 1 / (2 * kPi), 1e-15);
  }
}

// (5)
TEST(TestedShares2, LightInASolidGivesNothing) {
  Scene2 scene;  // counter-clockwise: fronts outside
  add_polygon(scene, {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  for (Surface& surface : scene.surfaces) surface.group = 0;
  scene.groups.resize(1, Group("box"));
  for (const LightTest test : kTests) {
    const LightShares shares = shares_in(scene, bulb(), {{kHalf, kHalf}}, test);
    EXPECT_EQ(shares.solid, "edge0");
    EXPECT_EQ(sum_of(shares), 0);
  }
}

TEST(TestedShares2, ComeToThePowerAsElementsBecomeSmall) {
  for (const LightTest test : kTests) {
    double before = 1;
    for (const std::uint32_t elements : {1u, 4u, 16u, 64u}) {
      Scene2 scene = square_room();
      for (Surface& surface : scene.surfaces) surface.elements = elements;
      const double defect = std::fabs(sum_of(shares_in(scene, bulb(), {{Rational(1, 3), Rational(2, 5)}}, test)) - 1);
      EXPECT_LT(defect, before / (elements == 1 ? 1 : 8)) << elements;
      before = defect;
    }
    EXPECT_LT(before, 1e-3);
  }
}

// A box on a floor leaves two runs of one element of the floor, and each is lit by itself.
TEST(TestedShares2, RunsOfAnElementAreLitEachByItself) {
  Scene2 scene;
  add_edge(scene, {4, 0}, {0, 0});  // front upward
  add_polygon(scene, {{1, 0}, {2, 0}, {2, 3}, {1, 3}});
  for (std::size_t k = 1; k < 5; ++k) scene.surfaces[k].group = 1;
  const LightShares shares = shares_in(scene, bulb(), {{3, 2}}, LightTest::kCentroid);
  // Only the run from 2 to 4 is seen: I A cos / r with A = 2, r = 2.
  EXPECT_NEAR(share(shares, 0), 1 / (2 * kPi), 1e-15);
}

// Beyond the range of doubles it is refused by name.
TEST(TestedShares2, TooNearForDoublesIsToldByName) {
  Scene2 scene = square_room();
  scene.file = "near.json";
  const Rational tiny = Rational(1, Integer(1) << 1100);
  try {
    shares_in(scene, bulb(), {{kHalf, tiny}}, LightTest::kCentroid);
    FAIL();
  } catch (const RequestError& error) {
    EXPECT_STREQ(error.what(), "near.json: the share of light 'bulb' that 'edge3' gets is beyond the range of doubles");
  }
}

// Random edges against a test of every edge in rationals. No two points lie on a line with a third.
TEST(TestedShares2, AreThoseOfASlowOracleInRandomScenes) {
  std::mt19937 random(7);
  const auto draw = [&](int most) { return Rational(static_cast<int>(random() % static_cast<unsigned>(most))); };
  const auto turn = [](const Point2& a, const Point2& b, const Point2& c) {
    return sgn(Rational((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)));
  };
  std::size_t lit = 0, half = 0, dark = 0;
  for (int round = 0; round < 200; ++round) {
    Scene2 scene;
    while (scene.edges.size() < 9) {
      Point2 a{draw(100000), draw(100000)}, b{draw(100000), draw(100000)};
      if (!(a == b)) add_edge(scene, a, b, true);
    }
    for (Surface& surface : scene.surfaces) surface.elements = 3;
    const int focus = 10 + static_cast<int>(random() % 120), falloff = static_cast<int>(random() % 3);
    const Light light = spot(focus, falloff);
    const LightPlace2 place{{draw(100000) + Rational(1, 3), draw(100000) + Rational(2, 7)},
                            {draw(19) - 9, draw(19) - Rational(17, 2)}};
    const Point2& from = place.position;
    const double cut = to_double(light.half_angle()) * kPi / 180;
    const double power = falloff == 0 ? cut : falloff == 1 ? std::sin(cut) : (cut + std::sin(cut) * std::cos(cut)) / 2;
    const auto angle = [&](const Point2& p) {
      const double dx = to_double(p.x - from.x), dy = to_double(p.y - from.y), ax = to_double(place.direction.x),
                   ay = to_double(place.direction.y);
      return std::fabs(std::atan2(ax * dy - ay * dx, ax * dx + ay * dy));
    };
    const auto passes = [&](const Point2& p, std::size_t own) {
      if (angle(p) > cut) return false;
      for (std::size_t k = 0; k < scene.edges.size(); ++k) {
        const Edge2& edge = scene.edges[k];
        if (k != own && turn(from, p, edge.from) * turn(from, p, edge.to) < 0 &&
            turn(edge.from, edge.to, from) * turn(edge.from, edge.to, p) < 0)
          return false;
      }
      return true;
    };
    for (const LightTest test : kTests) {
      const LightShares shares = shares_in(scene, light, place, test);
      for (std::size_t k = 0; k < 9; ++k)
        for (std::size_t side = 0; side < 2; ++side)
          for (std::size_t part = 0; part < 3; ++part) {
            const Edge2& edge = scene.edges[k];
            const auto at = [&](const Rational& t) {
              return Point2{edge.from.x + t * (edge.to.x - edge.from.x), edge.from.y + t * (edge.to.y - edge.from.y)};
            };
            const Rational low = Rational(static_cast<int>(part)) / 3, high = Rational(static_cast<int>(part) + 1) / 3;
            const Point2 a = at(low), b = at(high), c = at((low + high) / 2);
            const bool is_front = turn(edge.from, edge.to, from) < 0;
            const double weight = is_front != (side == 0)        ? 0
                                  : test == LightTest::kCentroid ? passes(c, k)
                                                                 : (passes(a, k) + passes(b, k)) / 2.0;
            const double x = to_double(c.x - from.x), y = to_double(c.y - from.y), r = std::hypot(x, y);
            const double dx = to_double(b.x - a.x), dy = to_double(b.y - a.y);
            const double cosine = std::cos(angle(c));
            const double intensity = falloff > 0 && cosine <= 0 ? 0 : std::pow(cosine, falloff) / (2 * power);
            const double expected = weight * intensity * std::fabs(dx * y - dy * x) / (r * r);
            const double found = share(shares, 6 * k + 3 * side + part);
            EXPECT_NEAR(found, expected, 1e-12 * (1 + expected)) << round << " " << k << " " << side << " " << part;
            ++(weight == 0 ? dark : weight == 1 ? lit : half);
          }
    }
  }
  EXPECT_GT(lit, 500u);
  EXPECT_GT(half, 100u);
  EXPECT_GT(dark, 1000u);
}

// Lights by a test are a stage: factors and system stay, what follows is made anew, and is said to be an estimate.
TEST(TestedShares2, AreTheLightsOfASimulationThatAsksForThem) {
  Scene2 scene = square_room();
  scene.materials[0].reflectivity = Spectrum::scalar(kHalf);
  scene.add_light(bulb(), {{kHalf, kHalf}});
  const Simulation2 exact(scene);
  SimulationRequest2 request = exact.request();
  request.lights = LightTest::kCentroid;
  const Simulation2 tested = exact.with_request(request);
  EXPECT_EQ(tested.factors(), exact.factors());
  EXPECT_EQ(tested.system(), exact.system());
  EXPECT_NE(tested.light_shares(), exact.light_shares());
  EXPECT_EQ(tested.check(), exact.check());
  const RadiositySolution &of_exact = *exact.radiosities(), &of_tested = *tested.radiosities();
  EXPECT_EQ(of_exact.guarantee, Guarantee::kEnclosed);
  EXPECT_EQ(of_tested.guarantee, Guarantee::kEstimated);
  EXPECT_NEAR(of_exact.energy.defect, 0, 1e-15);
  EXPECT_NEAR(of_tested.energy.emitted, 1, 1e-15);
  EXPECT_NEAR(of_tested.energy.absorbed, 4 / kPi, 1e-14);
  EXPECT_NEAR(of_tested.energy.defect, 1 - 4 / kPi, 1e-14);
  for (std::size_t wall = 0; wall < 4; ++wall) {
    const ElementRadiosity& at = of_tested.channels[0].elements[2 * wall];
    EXPECT_NEAR(at.radiosity, 1 / kPi, 1e-14);  // rho D / (1 - rho)
    EXPECT_LE(at.lower, at.radiosity);
    EXPECT_LE(at.radiosity, at.upper);
  }
  request.lights = LightTest::kExact;
  EXPECT_EQ(exact.with_request(request).radiosities(), exact.radiosities());
}

}  // namespace
}  // namespace hottel::tested_shares_test

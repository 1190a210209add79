// Shares of lights by centroids and by vertices, in space: closed forms, borders, a slow oracle.
#include "solver/space/light/tested_shares.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "kernel/support/failure.h"
#include "solver/radiosity/radiosity_solver.h"
#include "solver/space/light/scene_light_shares.h"
#include "solver/space/simulation/simulation.h"
#include "tests/geometry/space/box_scene.h"

namespace hottel::tested_shares_test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr LightTest kTests[] = {LightTest::kCentroid, LightTest::kVertices};

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

// The shares of one light with the names of what gets them.
struct Lit {
  std::vector<Element> elements;
  LightShares shares;

  double at(const std::string& name) const {
    for (std::size_t k = 0; k < elements.size(); ++k)
      if (elements[k].name == name) return shares.of_element[k].lower;
    ADD_FAILURE() << name;
    return 0;
  }
  double sum() const {
    double result = shares.sky.upper;
    for (const Enclosure& share : shares.of_element) result += share.upper;
    return result;
  }
};

Lit lit(Scene3 scene, const Light& light, const LightPlace3& place, LightTest test) {
  scene.add_light(light, place);
  validate(scene);
  const PreparedScene3 prepared = prepare(std::move(scene));
  return {prepared.elements(Granularity::kElement)->elements(),
          light_shares(prepared, Granularity::kElement, test).front()};
}

Scene3 room(std::uint32_t elements = 1) {
  BoxScene3 scene;
  scene.box("room", {-1, -1, -1}, {1, 1, 1}, true);
  for (Surface& surface : scene.surfaces) surface.elements = elements;
  return scene;
}

LightPlace3 at(const Point3& position, const Vector3& direction = {1, 0, 0}) {
  LightPlace3 place;
  place.position = position;
  place.direction = direction;
  return place;
}
const LightPlace3 kMiddle = at({0, 0, 0});

// (1): A I / r^2 = 4 / (4 pi); together 6 / pi of the power.
TEST(TestedShares3, TakeTheValueAtTheCentroidForAllOfTheElement) {
  for (const LightTest test : kTests) {
    const Lit found = lit(room(), bulb(), kMiddle, test);
    EXPECT_EQ(found.shares.test, test);
    for (const char* side : {"bottom", "top", "south", "north", "west", "east"}) {
      EXPECT_NEAR(found.at(std::string("room ") + side), 1 / kPi, 1e-15);
      EXPECT_EQ(found.at(std::string("room ") + side + ":back"), 0);
    }
    EXPECT_NEAR(found.sum(), 6 / kPi, 1e-14);
  }
}

TEST(TestedShares3, OfExactAreThoseOfLightShares) {
  Scene3 scene = room(2);
  scene.add_light(spot(40, 2), at({0, 0, 0}, {3, 1, 2}));
  const PreparedScene3 prepared = prepare(scene);
  const LightShares exact = light_shares(prepared, Granularity::kElement, LightTest::kExact).front();
  EXPECT_EQ(exact.of_element, light_shares(prepared, Granularity::kElement).front().of_element);
  EXPECT_EQ(exact.test, LightTest::kExact);
}

// Of an element of the east wall, a quarter of it, one corner is in the axis and two are at 45 degrees.
TEST(TestedShares3, BorderOfABeamIsInIt) {
  const Rational tiny("1/1000000000000000000000000000000");
  const auto quarter = [](const Rational& focus, LightTest test) {
    return lit(room(2), spot(focus), kMiddle, test).at("room east#0");
  };
  const double cosine = std::sqrt(2.0 / 3);  // of the centroid (1, 1/2, 1/2), r^2 = 3/2
  const auto whole = [&](double focus) { return cosine / 1.5 / (2 * kPi * (1 - std::cos(focus * kPi / 180))); };
  EXPECT_NEAR(quarter(45, LightTest::kVertices), 0.75 * whole(45), 1e-14);
  EXPECT_NEAR(quarter(45 - tiny, LightTest::kVertices), 0.25 * whole(45), 1e-14);
  EXPECT_NEAR(quarter(45, LightTest::kCentroid), whole(45), 1e-14);
  EXPECT_EQ(quarter(35, LightTest::kCentroid), 0);  // the centroid is at 35.26 degrees
  EXPECT_NEAR(quarter(35, LightTest::kVertices), 0.25 * whole(35), 1e-14);
}

TEST(TestedShares3, VerticesWeighTheIntensityWithoutItsCut) {
  const Lit found = lit(room(2), spot(35, 2), kMiddle, LightTest::kVertices);
  const double cosine = std::sqrt(2.0 / 3), peak = 3 / (2 * kPi * (1 - std::pow(std::cos(35 * kPi / 180), 3)));
  EXPECT_NEAR(found.at("room east#0"), 0.25 * peak * cosine * cosine * cosine / 1.5, 1e-14);
  // A quarter of the top of which two corners are in the beam, and the centroid at 90 degrees, or a little before.
  for (const Rational& falloff : {Rational(1), Rational(1, 1000)}) {
    const auto above = [&](const Rational& x) {
      return lit(room(2), spot(80, falloff), at({x, Rational(-1, 2), 0}), LightTest::kVertices).at("room top#0");
    };
    EXPECT_EQ(above(Rational(-1, 2)), 0);
    EXPECT_GT(above(Rational(-3, 5)), 0);
  }
}

TEST(TestedShares3, LightInThePlaneOfAnElementOrBehindItGivesNothing) {
  BoxScene3 scene;
  scene.box("room", {-1, -1, -1}, {1, 1, 1}, true);
  scene.polygon("plate", level(Rational(1, 4), 0, Rational(1, 2), Rational(1, 2), 0), 0, 0);
  for (const LightTest test : kTests) {
    EXPECT_EQ(lit(scene, bulb(), kMiddle, test).at("plate"), 0);
    EXPECT_EQ(lit(scene, bulb(), kMiddle, test).at("plate:back"), 0);
    const Lit above = lit(scene, bulb(), at({0, 0, Rational(1, 2)}), test);
    EXPECT_GT(above.at("plate"), 0);
    EXPECT_EQ(above.at("plate:back"), 0);
  }
}

// A screen before the middle of the east wall: what only touches the way hides nothing.
TEST(TestedShares3, TouchedEdgeDoesNotHide) {
  const Rational tiny("1/1000000000000000000000000000000");
  const auto behind = [](const Rational& top, LightTest test) {
    BoxScene3 scene;
    scene.box("room", {-1, -1, -1}, {1, 1, 1}, true);
    const Rational x(1, 2);
    scene.polygon("screen", {{{x, -1, -1}, {x, 1, -1}, {x, 1, top}, {x, -1, top}}}, 0, 0);
    return lit(scene, bulb(), kMiddle, test).at("room east");
  };
  EXPECT_NEAR(behind(0, LightTest::kCentroid), 1 / kPi, 1e-15);
  EXPECT_EQ(behind(tiny, LightTest::kCentroid), 0);
  EXPECT_NEAR(behind(Rational(-1, 2), LightTest::kVertices), 1 / kPi, 1e-15);
  EXPECT_NEAR(behind(Rational(-1, 2) + tiny, LightTest::kVertices), 0.5 / kPi, 1e-15);
}

// (4)
TEST(TestedShares3, ShareOfTheSkyIsExact) {
  BoxScene3 scene;
  scene.polygon("plate", level(-1, -1, 1, 1, -1));
  for (const LightTest test : kTests) {
    const Lit found = lit(scene, bulb(), kMiddle, test);
    EXPECT_NEAR(found.shares.sky.lower, 5.0 / 6, 1e-15);
    EXPECT_NEAR(found.at("plate"), 1 / kPi, 1e-15);
  }
}

// (5)
TEST(TestedShares3, LightInASolidGivesNothing) {
  BoxScene3 scene;
  scene.box("box", {-1, -1, -1}, {1, 1, 1});
  for (const LightTest test : kTests) {
    const Lit found = lit(scene, bulb(), kMiddle, test);
    EXPECT_EQ(found.shares.solid, "box");
    EXPECT_EQ(found.sum(), 0);
  }
}

TEST(TestedShares3, ComeToThePowerAsElementsBecomeSmall) {
  for (const LightTest test : kTests) {
    double before = 1;
    for (const std::uint32_t elements : {2u, 4u, 8u, 16u}) {
      const Lit found = lit(room(elements), bulb(), at({Rational(1, 3), Rational(2, 5), 0}), test);
      const double defect = std::fabs(found.sum() - 1);
      EXPECT_LT(defect, before / (elements == 2 ? 1 : 2.5)) << elements;
      before = defect;
    }
    EXPECT_LT(before, 1e-2);
  }
}

// Elements may be of any size, however near the light is; beyond the range of doubles it is refused by name.
TEST(TestedShares3, AreOfAnySizeThatDoublesHave) {
  Scene3 scene = room();
  scene.file = "near.json";
  const auto above = [&](int bits) {
    const Rational height = Rational(-1) + Rational(1, Integer(1) << static_cast<unsigned>(bits));
    return lit(scene, bulb(), at({0, 0, height}), LightTest::kCentroid).at("room bottom");
  };
  EXPECT_DOUBLE_EQ(above(400), std::ldexp(1 / kPi, 800));
  try {
    above(600);
    FAIL();
  } catch (const RequestError& error) {
    EXPECT_STREQ(error.what(),
                 "near.json: the share of light 'bulb' that 'room bottom' gets is beyond the range of doubles");
  }
}

// Boxes in a room, each element a triangle or a quad, against a test of every polygon in rationals.
TEST(TestedShares3, AreThoseOfASlowOracleInRandomRooms) {
  std::mt19937 random(3);
  const auto draw = [&](int low, int high) {
    return Rational(low + static_cast<int>(random() % static_cast<unsigned>(high - low)));
  };
  std::size_t whole = 0, part = 0, dark = 0;
  for (int round = 0; round < 12; ++round) {
    BoxScene3 scene;
    scene.box("room", {0, 0, 0}, {10007, 10009, 10037}, true);
    for (int k = 0; k < 3; ++k) {
      const Rational x = 3000 * k + draw(100, 1000), y = draw(500, 6000), z = draw(500, 6000);
      scene.box("box" + std::to_string(k), {x, y, z}, {x + draw(500, 1900), y + draw(500, 3000), z + draw(500, 3000)});
    }
    scene.polygon("screen",
                  {{{draw(9000, 9400), draw(100, 3000), draw(100, 3000)},
                    {draw(9500, 9990), draw(5000, 9000), draw(100, 3000)},
                    {draw(9000, 9990), draw(3000, 8000), draw(5000, 9000)}}},
                  0, 0);
    for (Surface& surface : scene.surfaces) surface.elements = 2;
    const Rational focus = draw(15, 140), falloff = draw(0, 3);
    const Light light = spot(focus, falloff);
    const LightPlace3 place =
        at({draw(100, 9000) + Rational(1, 3), draw(7000, 9999) + Rational(1, 7), draw(9200, 9999)},
           {draw(-9, 9), draw(-9, 0) - Rational(1, 2), draw(-9, 0)});
    scene.add_light(light, place);
    validate(scene);
    const PreparedScene3 prepared = prepare(scene);
    if (prepared.arrangement().solids().around(place.position)) continue;
    const ElementTable3& table = *prepared.elements(Granularity::kElement);
    const Vertices3& vertices = prepared.occluders().vertices();
    const Point3& from = place.position;
    const auto place_of = [&](const IntegerVector& at, const Integer& weight) {
      const Rational scale = vertices.scale() / Rational(weight);
      return Point3{vertices.origin().x + scale * Rational(at.x), vertices.origin().y + scale * Rational(at.y),
                    vertices.origin().z + scale * Rational(at.z)};
    };
    const auto volume = [](const Vector3& a, const Vector3& b, const Vector3& c) { return sgn(dot(cross(a, b), c)); };
    const double cut = to_double(light.half_angle()) * kPi / 180, n = to_double(falloff);
    const auto cosine_at = [&](const Point3& p) {
      const Vector3 way = p - from, &axis = place.direction;
      return to_double(dot(way, axis)) / std::sqrt(to_double(dot(way, way)) * to_double(dot(axis, axis)));
    };
    const auto passes = [&](const Point3& p) {
      if (cosine_at(p) < std::cos(cut)) return false;
      for (const Polygon3& polygon : scene.polygons) {
        const std::vector<Point3>& q = polygon.points;
        const Vector3 normal = cross(q[1] - q[0], q[2] - q[0]);
        if (sgn(dot(normal, from - q[0])) * sgn(dot(normal, p - q[0])) >= 0) continue;
        bool is_within = true;
        for (std::size_t k = 0; k < q.size(); ++k)
          is_within &= volume(q[k] - from, q[(k + 1) % q.size()] - from, p - from) * sgn(dot(normal, from - q[0])) < 0;
        if (is_within) return false;
      }
      return true;
    };
    for (const LightTest test : kTests) {
      const LightShares shares = light_shares(prepared, Granularity::kElement, test).front();
      for (std::uint32_t label = 0; label < table.count(); ++label) {
        double expected = 0;
        for (const ElementTable3::Part& its : table.free_parts(label)) {
          std::vector<Point3> corners;
          for (const IntegerVector& corner : its.patch.corners) corners.push_back(place_of(corner, its.patch.weight));
          Point3 centroid{0, 0, 0};  // of triangles and parallelograms
          for (const Point3& corner : corners)
            centroid = {centroid.x + corner.x, centroid.y + corner.y, centroid.z + corner.z};
          const Rational count = static_cast<unsigned>(corners.size());
          centroid = {centroid.x / count, centroid.y / count, centroid.z / count};
          const Vector3 area = cross(corners[1] - corners[0], corners[2] - corners[1]), way = from - centroid;
          const double size = std::sqrt(to_double(dot(area, area))) / (corners.size() == 3 ? 2 : 1);
          const double r = std::sqrt(to_double(dot(way, way)));
          const double height = to_double(dot(area, way)) / std::sqrt(to_double(dot(area, area))) / r;
          if (height <= 0) continue;
          double weight = 0;
          if (test == LightTest::kCentroid)
            weight = passes(centroid);
          else
            for (const Point3& corner : corners) weight += passes(corner) / static_cast<double>(corners.size());
          const double c = cosine_at(centroid), peak = (n + 1) / (2 * kPi * (1 - std::pow(std::cos(cut), n + 1)));
          expected += weight * size * height / (r * r) * (n > 0 && c <= 0 ? 0 : peak * std::pow(c, n));
          ++(weight == 0 ? dark : weight > 0.99 ? whole : part);
        }
        EXPECT_NEAR(shares.of_element[label].lower, expected, 1e-11 * (1 + expected))
            << round << " " << table.elements()[label].name << " " << to_string(test);
      }
    }
  }
  EXPECT_GT(whole, 100u);
  EXPECT_GT(part, 30u);
  EXPECT_GT(dark, 100u);
}

// Lights by a test are a stage: factors and system stay, what follows is made anew, and is said to be an estimate.
TEST(TestedShares3, AreTheLightsOfASimulationThatAsksForThem) {
  Scene3 scene = room();
  scene.add_light(bulb(), kMiddle);
  const Simulation3 exact(scene);
  SimulationRequest3 request = exact.request();
  request.lights = LightTest::kVertices;
  const Simulation3 tested = exact.with_request(request);
  EXPECT_EQ(tested.factors(), exact.factors());
  EXPECT_EQ(tested.system(), exact.system());
  EXPECT_NE(tested.light_shares(), exact.light_shares());
  const RadiositySolution &of_exact = *exact.radiosities(), &of_tested = *tested.radiosities();
  EXPECT_EQ(of_exact.guarantee, Guarantee::kEnclosed);
  EXPECT_EQ(of_tested.guarantee, Guarantee::kEstimated);
  EXPECT_NEAR(of_tested.energy.emitted, 1, 1e-14);
  EXPECT_NEAR(of_tested.energy.defect, 1 - 6 / kPi, 1e-9);
  EXPECT_NEAR(of_tested.channels[0].elements[0].radiosity, 1 / (4 * kPi), 1e-9);  // rho D / (1 - rho), D = 1 / (4 pi)
  request.lights = LightTest::kExact;
  EXPECT_EQ(exact.with_request(request).radiosities(), exact.radiosities());
  std::vector<Material> materials = scene.materials;
  materials[0].emission = Spectrum::scalar(1);
  EXPECT_EQ(tested.with_materials(materials).light_shares(), tested.light_shares());
}

}  // namespace
}  // namespace hottel::tested_shares_test

// Which points a light in the plane reaches: against every edge, one by one, and where shadows end.
#include "solver/plane/light/lit_region.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "solver/plane/light/illumination_grid.h"
#include "tests/solver/plane/lit_scenes.h"

namespace hottel::lit_region_test {
namespace {

Light bulb(const Rational& power = 1) {
  Light light;
  light.name = "bulb";
  light.power = Spectrum::scalar(power);
  return light;
}

struct Region {
  Region(Scene2 scene, const Light& light, const LightPlace2& place)
      : prepared(prepare(std::move(scene))),
        location(prepared.arrangement.vertices(), prepared.arrangement.triangulation()),
        lit(prepared, location, light, place) {}

  Eye2 eye(const Point2& point) const {
    const Vertices2& vertices = prepared.arrangement.vertices();
    return {vertices, vertices.from_scene(point)};
  }
  bool reaches(const Point2& point) const { return lit.reaches(eye(point)); }
  double irradiance(const Point2& point) const { return lit.irradiance(eye(point)); }

  PreparedScene2 prepared;
  PointLocation2 location;
  LitRegion2 lit;
};

int turn(const Point2& a, const Point2& b, const Point2& c) {
  return sgn(Rational((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)));
}

// (1), where nothing is on a line with anything else
TEST(LitRegion2, ReachesWhatNoEdgeHides) {
  std::mt19937 random(5);
  const auto draw = [&] { return Rational(static_cast<int>(random() % 1000)); };
  std::size_t lit = 0, dark = 0;
  for (int round = 0; round < 200; ++round) {
    Scene2 scene;
    const int edges = static_cast<int>(random() % 12);
    for (int k = 0; k < edges; ++k) {
      const Point2 a{draw(), draw()}, b{draw(), draw()};
      if (!(a == b)) add_edge(scene, a, b);
    }
    const Point2 from{draw() + Rational(1, 3), draw() + Rational(1, 7)};
    const Region region(scene, bulb(), {from});
    for (int k = 0; k < 50; ++k) {
      const Point2 to{draw() + Rational(2, 11), draw() + Rational(5, 13)};
      bool is_free = true;
      for (const Edge2& edge : scene.edges)
        is_free &= turn(from, to, edge.from) * turn(from, to, edge.to) >= 0 ||
                   turn(edge.from, edge.to, from) * turn(edge.from, edge.to, to) >= 0;
      EXPECT_EQ(region.reaches(to), is_free) << "round " << round;
      ++(is_free ? lit : dark);
    }
  }
  EXPECT_GT(lit, 1000u);
  EXPECT_GT(dark, 1000u);
}

TEST(LitRegion2, BordersOfShadowsAndWhatIsShoneOnAreLit) {
  Scene2 scene;
  add_edge(scene, {1, -1}, {1, 1});
  const Region region(scene, bulb(), {{0, 0}});
  EXPECT_TRUE(region.reaches({1, 0}));  // on the edge
  EXPECT_TRUE(region.reaches({1, 1}));  // its end
  EXPECT_TRUE(region.reaches({2, 2}));  // behind the end: the shift to the left is free
  EXPECT_TRUE(region.reaches({2, -2}));
  EXPECT_FALSE(region.reaches({2, Rational(199, 100)}));
  EXPECT_FALSE(region.reaches({2, 0}));
  EXPECT_TRUE(region.reaches({-5, 0}));
  EXPECT_TRUE(region.reaches({0, 0}));  // at the light
  const Region seen_edge_on(scene, bulb(), {{1, 5}});
  EXPECT_TRUE(seen_edge_on.reaches({1, 0}));
  EXPECT_TRUE(seen_edge_on.reaches({1, -3}));  // along it both shifts are free
}

TEST(LitRegion2, DoubleBorderOfTwoEdgesIsDark) {
  Scene2 scene;
  add_edge(scene, {1, 1}, {1, 3});
  add_edge(scene, {2, 2}, {2, -3});
  const Region region(scene, bulb(), {{0, 0}});
  EXPECT_FALSE(region.reaches({3, 3}));  // one edge ends on the left of the way, the other on its right
  EXPECT_TRUE(region.reaches({Rational(3, 2), Rational(3, 2)}));
}

// (2)
TEST(LitRegion2, LightInASolidReachesNothing) {
  Scene2 scene;
  add_polygon(scene, {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  for (Surface& surface : scene.surfaces) surface.group = 0;
  scene.groups.resize(1, Group("box"));
  const Region region(scene, bulb(), {{Rational(1, 2), Rational(1, 2)}});
  EXPECT_FALSE(region.reaches({Rational(1, 3), Rational(1, 3)}));
  EXPECT_EQ(region.irradiance({3, 3}), 0);
}

TEST(LitRegion2, IrradianceFallsWithTheDistance) {
  Light spot = bulb();
  spot.type = LightType::kSpot;
  spot.focus = 45;
  const Region round(square_room(), bulb(), {{Rational(1, 2), Rational(1, 2)}});
  const Region beam(square_room(), spot, {{Rational(1, 2), Rational(1, 2)}, {1, 0}});
  const double pi = std::numbers::pi;
  EXPECT_DOUBLE_EQ(round.irradiance({Rational(3, 4), Rational(1, 2)}), 1 / (2 * pi) / (pi * 0.25));
  EXPECT_DOUBLE_EQ(beam.irradiance({Rational(3, 4), Rational(1, 2)}), 4 / (2 * pi) / (pi * 0.25));
  EXPECT_EQ(beam.irradiance({Rational(1, 4), Rational(1, 2)}), 0);
  EXPECT_GT(beam.irradiance({Rational(3, 4), Rational(3, 4)}), 0);  // on the border of the beam
  EXPECT_TRUE(std::isinf(round.irradiance({Rational(1, 2), Rational(1, 2)})));
}

// The grid is the light between the faces, and that of the lights.
TEST(LitRegion2, GridsHaveTheLightOfAllLights) {
  Scene2 scene = pillar_room();
  scene.add_light(bulb(3), {{Rational(1, 5), Rational(1, 5)}});
  const PreparedScene2 prepared = prepare(scene);
  const Grid2 grid{{0, 0}, {1, 1}, 9, 7};
  IlluminationGrid2 dark{grid, 1, std::vector<double>(63, 0.25)};
  dark.values[30] = std::nan("");
  const IlluminationGrid2 lit = with_lights(prepared, dark);
  const Region region(scene, bulb(), {{Rational(1, 5), Rational(1, 5)}});
  for (std::uint32_t iy = 0; iy < 7; ++iy)
    for (std::uint32_t ix = 0; ix < 9; ++ix) {
      const Point2 centre{Rational(2 * ix + 1, 18), Rational(2 * iy + 1, 14)};
      if (iy * 9 + ix == 30) {
        EXPECT_TRUE(std::isnan(lit.at(ix, iy)));
      } else {
        Point2 reduced = centre;
        reduced.x.canonicalize();
        reduced.y.canonicalize();
        EXPECT_DOUBLE_EQ(lit.at(ix, iy), 0.25 + 3 * region.irradiance(reduced)) << ix << " " << iy;
      }
    }
}

}  // namespace
}  // namespace hottel::lit_region_test

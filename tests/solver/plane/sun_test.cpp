// Suns in the plane: what rays meet first against a slow oracle, lit lengths by hand, borders, grids and turns.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/scene/moving_lights.h"
#include "geometry/plane/visibility/sun_view.h"
#include "kernel/support/failure.h"
#include "solver/plane/light/light_shares.h"
#include "solver/plane/light/lit_region.h"
#include "solver/plane/light/refinement.h"
#include "solver/plane/light/tested_shares.h"
#include "tests/solver/plane/lit_scenes.h"

namespace hottel::sun_test {
namespace {

const Rational kHalf(1, 2);

Light sun(const Rational& irradiance = 1) {
  Light light;
  light.name = "sun";
  light.type = LightType::kSun;
  light.power = Spectrum::scalar(irradiance);
  return light;
}

LightPlace2 along(const Point2& direction) { return {.position = {}, .direction = direction}; }

LightShares shares_in(Scene2 scene, const Point2& direction, LightTest test = LightTest::kExact,
                      Granularity granularity = Granularity::kFace) {
  scene.add_light(sun(), along(direction));
  validate(scene);
  const Divided2 divided = granularity == Granularity::kElement ? Divided2::kYes : Divided2::kNo;
  return light_shares(prepare(std::move(scene), divided), granularity, test).front();
}

void expect_length(const Enclosure& share, double length, const std::string& what) {
  EXPECT_TRUE(share.lower <= length * (1 + 0x1p-50) && length * (1 - 0x1p-50) <= share.upper)
      << what << ": " << share.lower << " to " << share.upper << ", not " << length;
  EXPECT_LE(share.width(), 0x1p-48 * share.upper) << what;
}

const Enclosure kNothing{0, 0};

// Ground from 0 to 10, and a wall of height 3 at 4: fronts up, and to both sides. Faces: ground 0 and 1, wall 2 and 3.
Scene2 wall_on_ground() {
  Scene2 scene;
  add_edge(scene, {10, 0}, {0, 0}, true);
  add_edge(scene, {4, 0}, {4, 3}, true);
  return scene;
}

// Rays fall by 3 on 4 to the right: the shadow of the wall is 4 long, its side towards the sun is lit from top to foot.
TEST(Sun2, AWallThrowsItsShadowOnTheGround) {
  const LightShares shares = shares_in(wall_on_ground(), {4, -3});
  expect_length(shares.of_element[0], 6 * 0.6, "ground");  // the cosine on level ground is 3/5
  EXPECT_EQ(shares.of_element[1], kNothing);
  EXPECT_EQ(shares.of_element[2], kNothing);  // the front is to the right
  expect_length(shares.of_element[3], 3 * 0.8, "side to the sun");
  expect_length(shares.whole, 6, "all");  // ground of 10 across the rays: what the wall takes the ground lacks
  EXPECT_EQ(shares.sky, kNothing);
  EXPECT_TRUE(shares.solid.empty());
}

TEST(Sun2, TakesNothingWhereItsRaysRunAlong) {
  const LightShares level = shares_in(wall_on_ground(), {7, 0});
  for (const std::size_t k : {0, 1, 2}) EXPECT_EQ(level.of_element[k], kNothing) << k;
  expect_length(level.of_element[3], 3, "wall");
  const LightShares noon = shares_in(wall_on_ground(), {0, -2});
  expect_length(noon.of_element[0], 10, "ground");
  for (const std::size_t k : {1, 2, 3}) EXPECT_EQ(noon.of_element[k], kNothing) << k;
}

TEST(Sun2, ShinesOnBacks) {
  const LightShares shares = shares_in(wall_on_ground(), {-4, 3});
  EXPECT_EQ(shares.of_element[0], kNothing);
  expect_length(shares.of_element[1], 10 * 0.6, "from below");
  EXPECT_EQ(shares.of_element[2], kNothing);
  EXPECT_EQ(shares.of_element[3], kNothing);
}

// Irrational only by the length of the direction: 1/sqrt(5) of 5.
TEST(Sun2, SlantedDirectionsAreExactRationals) {
  const LightShares shares = shares_in(wall_on_ground(), {Rational(1, 3), Rational(-2, 3)});
  expect_length(shares.of_element[0], (10 - 1.5) * 2 / std::sqrt(5.0), "ground");
  expect_length(shares.of_element[3], 3 / std::sqrt(5.0), "wall");
  const Rational small("1/" + ("1" + std::string(300, '0')));
  const LightShares tiny = shares_in(wall_on_ground(), {small, -2 * small});
  EXPECT_EQ(tiny.of_element, shares.of_element);
}

TEST(Sun2, AClosedRoomIsDarkAndAWindowLetsItIn) {
  for (const Point2& direction : {Point2{1, -2}, Point2{0, 1}, Point2{-3, 1}}) {
    Scene2 scene = square_room();
    scene.add_light(sun(), along(direction));
    const LightShares shares = light_shares(prepare(scene), Granularity::kFace).front();
    for (std::size_t k = 0; k < 8; k += 2) EXPECT_EQ(shares.of_element[k], kNothing);  // fronts look inward
  }
  Scene2 open;  // clockwise, without the half of the roof from 1/2 on
  add_edge(open, {1, 0}, {0, 0});
  add_edge(open, {0, 0}, {0, 1});
  add_edge(open, {0, 1}, {kHalf, 1});
  add_edge(open, {1, 1}, {1, 0});
  const LightShares shares = shares_in(open, {-1, -2});  // what enters between 1/2 and 1 arrives between 0 and 1/2
  expect_length(shares.of_element[0], 0.5 * 2 / std::sqrt(5.0), "floor");
  EXPECT_EQ(shares.of_element[2], kNothing);
  const LightShares steep = shares_in(open, {-3, -2});  // moves by 3/2 going down: all of it meets the left wall
  EXPECT_EQ(steep.of_element[0], kNothing);
  expect_length(steep.of_element[2], (0.5 * 2) / std::sqrt(13.0), "left wall");
}

// A convex body takes what its outline is across the rays, whatever these are.
TEST(Sun2, ConvexBodiesTakeTheirWidth) {
  std::mt19937 random(5);
  for (int run = 0; run < 50; ++run) {
    Scene2 scene;
    std::vector<Point2> corners{{0, 0}, {5, -1}, {8, 2}, {7, 6}, {3, 7}, {-1, 4}};
    add_polygon(scene, corners);
    const Point2 d{static_cast<int>(random() % 41) - 20, static_cast<int>(random() % 41) - 20};
    if (d == Point2{0, 0}) continue;
    const LightShares shares = shares_in(scene, d);
    Rational low = d.x * corners[0].y - d.y * corners[0].x, high = low;
    for (const Point2& p : corners) {
      const Rational across = d.x * p.y - d.y * p.x;
      low = std::min(low, across);
      high = std::max(high, across);
    }
    const double width = to_double(high - low) / std::hypot(to_double(d.x), to_double(d.y));
    expect_length(shares.whole, width, "whole");
    double sum = 0;
    for (const Enclosure& share : shares.of_element) sum += share.upper;
    EXPECT_NEAR(sum, width, 1e-13);
  }
}

TEST(Sun2, ElementsShareWhatTheirFaceGets) {
  Scene2 scene = wall_on_ground();
  for (Surface& surface : scene.surfaces) surface.elements = 5;  // of 2 on the ground; the shadow is from 4 to 8
  const LightShares shares = shares_in(scene, {4, -3}, LightTest::kExact, Granularity::kElement);
  for (const std::size_t lit : {0, 3, 4}) expect_length(shares.of_element[lit], 2 * 0.6, "lit");
  for (const std::size_t dark : {1, 2}) EXPECT_EQ(shares.of_element[dark], kNothing);
}

TEST(Sun2, TestsOfPointsAskTheSamePoints) {
  const auto at = [](LightTest test) { return shares_in(wall_on_ground(), {4, -3}, test); };
  EXPECT_EQ(at(LightTest::kCentroid).of_element[0], kNothing);  // its middle, 5, is in the shadow
  EXPECT_NEAR(at(LightTest::kVertices).of_element[0].lower, 6, 1e-14);
  EXPECT_NEAR(at(LightTest::kCentroid).of_element[3].lower, 2.4, 1e-14);
  expect_length(at(LightTest::kCentroid).whole, 6, "whole");
}

// Where a ray meets segments: brute force in rationals. Nothing where it passes through an end or along a segment.
struct SlowRay {
  bool is_plain = true;
  std::optional<Rational> depth;  // of the first, along the rays, in scene coordinates
  std::size_t surface = 0;
};
SlowRay slow_ray(const Scene2& scene, const Point2& d, const Rational& across) {
  SlowRay result;
  for (std::size_t k = 0; k < scene.edges.size(); ++k) {
    const auto& [a, b] = scene.edges[k];
    const Rational of_a = d.x * a.y - d.y * a.x - across, of_b = d.x * b.y - d.y * b.x - across;
    if (of_a == 0 || of_b == 0) result.is_plain = false;
    if (sgn(of_a) * sgn(of_b) >= 0) continue;
    const Rational t = of_a / (of_a - of_b);
    const Rational depth = d.x * (a.x + t * (b.x - a.x)) + d.y * (a.y + t * (b.y - a.y));
    if (result.depth && depth == *result.depth && result.surface != k) result.is_plain = false;
    if (result.depth && depth >= *result.depth) continue;
    result.depth = depth;
    result.surface = k;
  }
  return result;
}

TEST(Sun2, RaysMeetWhatTheSlowWayMeetsAndPointsAreLitBeforeIt) {
  std::mt19937 random(11);
  int compared = 0, in_shadow = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    const Scene2 scene = random_lattice_scene(seed, 14);
    const Point2 d{static_cast<int>(random() % 15) - 7, static_cast<int>(random() % 15) - 7};
    if (d == Point2{0, 0}) continue;
    const PreparedScene2 prepared = prepare(scene);
    const Vertices2& vertices = prepared.arrangement.vertices();
    const SunView2 view(prepared.arrangement, d);
    for (int k = 0; k < 60; ++k) {
      const Point2 p{Rational(static_cast<int>(random() % 900), 97), Rational(static_cast<int>(random() % 900), 89)};
      const SlowRay slow = slow_ray(scene, d, d.x * p.y - d.y * p.x);
      if (!slow.is_plain) continue;
      ++compared;
      const Eye2 eye(vertices, vertices.from_scene(p));
      const bool is_lit = !slow.depth || d.x * p.x + d.y * p.y <= *slow.depth;
      in_shadow += is_lit ? 0 : 1;
      EXPECT_EQ(view.reaches(eye), is_lit) << seed << " " << k;
      const Rational across = view.across(vertices.from_scene(p));
      std::optional<std::size_t> met;
      for (const SunView2::Strip& strip : view.strips())
        if (view.across(strip.from) < across && across < view.across(strip.to)) {
          EXPECT_FALSE(met);
          met = prepared.arrangement.owner(strip.side).surface;
        }
      EXPECT_EQ(met.has_value(), slow.depth.has_value()) << seed << " " << k;
      if (met && slow.depth) {
        EXPECT_EQ(*met, slow.surface) << seed << " " << k;
      }
    }
  }
  EXPECT_GT(compared, 1000);
  EXPECT_GT(in_shadow, 300);
}

// What random suns light of each face is what a ray in each strip between ends and crossings meets, by brute force.
TEST(Sun2, LitLengthsAreWhatRaysCount) {
  std::mt19937 random(23);
  int faces_lit = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    Scene2 scene = random_lattice_scene(seed, 9);
    const Point2 d{static_cast<int>(random() % 15) - 7, static_cast<int>(random() % 15) - 7};
    if (d == Point2{0, 0}) continue;
    std::vector<Rational> borders;
    const auto across = [&](const Point2& p) { return Rational(d.x * p.y - d.y * p.x); };
    for (const Edge2& a : scene.edges) {
      borders.insert(borders.end(), {across(a.from), across(a.to)});
      for (const Edge2& b : scene.edges) {
        const Rational from = doubled_area(a.from, a.to, b.from), to = doubled_area(a.from, a.to, b.to);
        if (from == to) continue;
        borders.push_back(across(point_at(b, from / (from - to))));
      }
    }
    std::ranges::sort(borders);
    std::vector<Rational> lit(2 * scene.edges.size());
    std::vector<char> is_plain(2 * scene.edges.size(), 1);
    for (std::size_t k = 0; k + 1 < borders.size(); ++k) {
      if (borders[k] == borders[k + 1]) continue;
      const SlowRay ray = slow_ray(scene, d, (borders[k] + borders[k + 1]) / 2);
      if (!ray.depth) continue;
      const Edge2& edge = scene.edges[ray.surface];
      const bool is_back = across(edge.from) < across(edge.to);  // fronts look to the right
      const std::size_t face = 2 * ray.surface + (is_back ? 1 : 0);
      lit[face] += borders[k + 1] - borders[k];
      // Two on one line: which of them owns it is asked elsewhere.
      if (!ray.is_plain)
        for (std::size_t other = 0; other < scene.edges.size(); ++other)
          if (doubled_area(edge.from, edge.to, scene.edges[other].from) == 0 &&
              doubled_area(edge.from, edge.to, scene.edges[other].to) == 0)
            is_plain[2 * other] = is_plain[2 * other + 1] = 0;
    }
    const PreparedScene2 prepared = prepare(scene);
    const ElementTable2& table = *prepared.elements(Granularity::kFace);
    const LightShares shares = shares_in(std::move(scene), d);
    const double length = std::sqrt(to_double(d.x * d.x + d.y * d.y));
    for (std::uint32_t e = 0; e < table.count(); ++e) {
      const std::size_t face = 2 * table.elements()[e].surface + (table.elements()[e].is_back ? 1 : 0);
      if (is_plain[face] == 0) continue;
      faces_lit += lit[face] > 0;
      EXPECT_NEAR(shares.of_element[e].lower, to_double(lit[face]) / length, 1e-13) << seed << " " << face;
    }
  }
  EXPECT_GT(faces_lit, 100);
}

// What is lit is at the border of the shadow, on what the sun shines on, and beyond an end that the ray only touches.
TEST(Sun2, BordersOfShadowsAreLit) {
  Scene2 scene = wall_on_ground();
  scene.add_light(sun(9), along({4, -3}));
  const PreparedScene2 prepared = prepare(scene);
  const LitRegions2 regions(prepared);
  EXPECT_FALSE(regions.is_empty());
  EXPECT_EQ(regions.count(), 0u);  // no lamp
  const Vertices2& vertices = prepared.arrangement.vertices();
  const auto light_at = [&](const Rational& x, const Rational& y) {
    double result = 0;
    regions.add(Eye2(vertices, vertices.from_scene({x, y})), {&result, 1});
    return result;
  };
  const double full = 9 / std::numbers::pi;
  EXPECT_DOUBLE_EQ(light_at(1, 1), full);
  EXPECT_EQ(light_at(5, 1), 0);
  EXPECT_DOUBLE_EQ(light_at(6, Rational(3, 2)), full);  // on the border
  EXPECT_EQ(light_at(6, Rational(3, 2) - Rational(1, 1000000000)), 0);
  EXPECT_DOUBLE_EQ(light_at(4, 1), full);  // on the wall
  EXPECT_EQ(light_at(5, -1), 0);           // beneath the ground
  EXPECT_DOUBLE_EQ(light_at(100, 50), full);
  EXPECT_DOUBLE_EQ(light_at(-100, -50), full);
}

TEST(Sun2, ElementsAreDividedWhereShadowsEnd) {
  Scene2 scene = wall_on_ground();
  scene.add_light(sun(), along({4, -3}));
  const std::vector<SurfaceTrees> trees = refined_trees(prepare(scene), {.everywhere = 0, .at_borders = 3});
  // Of the ground, which runs from 10 to 0, shadow is from 2/10 to 6/10.
  std::vector<std::string> nodes;
  for (const TreeNode& leaf : trees[0].front) nodes.push_back(leaf.text());
  EXPECT_EQ(nodes, (std::vector<std::string>{"0/000", "0/001", "0/01", "0/100", "0/101", "0/11"}));
  EXPECT_TRUE(trees[1].back.empty());
}

TEST(Sun2, TurnsAsTimePassesAndQuartersAreExact) {
  const LightPlace2 place{.position = {}, .direction = {0, -1}, .rotation = 15};
  EXPECT_EQ(turned_direction(place_after(place, 0)), (Point2{0, -1}));
  EXPECT_EQ(turned_direction(place_after(place, 6)), (Point2{1, 0}));
  EXPECT_EQ(turned_direction(place_after(place, 12)), (Point2{0, 1}));
  EXPECT_EQ(turned_direction(place_after(place, 24)), (Point2{0, -1}));
  const LightPlace2 slanted{.position = {}, .direction = {Rational(1, 3), Rational(-1, 7)}, .rotation = -90};
  EXPECT_EQ(turned_direction(place_after(slanted, 1)), (Point2{Rational(-1, 7), Rational(-1, 3)}));
  const Point2 turned = turned_direction(place_after(place, 2));
  EXPECT_DOUBLE_EQ(to_double(turned.x), 0.5);
  EXPECT_DOUBLE_EQ(to_double(turned.y), -std::sqrt(3.0) / 2);
  Scene2 scene = wall_on_ground();
  scene.add_light(sun(), place);
  EXPECT_TRUE(has_moving_lights(scene));
}

TEST(Sun2, IsRefusedWithoutADirection) {
  Scene2 scene = wall_on_ground();
  scene.add_light(sun(), along({0, 0}));
  EXPECT_THROW(validate(scene), InputError);
}

}  // namespace
}  // namespace hottel::sun_test

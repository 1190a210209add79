#include "viewer/edit/plane/pick.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "geometry/plane/generate/generators.h"
#include "geometry/plane/scene/closest_point.h"
#include "tests/viewer/edit/plane/edited_scenes.h"

namespace hottel::pick_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// The squared distances to the nearest vertex and to the nearest edge, exactly.
struct NearestOfAll {
  Rational vertex, edge;
};

NearestOfAll nearest_of_all(const Scene2& scene, const Point2& p) {
  NearestOfAll nearest{-1, -1};
  const auto offer = [](Rational& least, const Rational& value) {
    if (least < 0 || value < least) least = value;
  };
  for (const auto& [from, to] : scene.edges) {
    offer(nearest.vertex, squared_distance(from, p));
    offer(nearest.vertex, squared_distance(to, p));
    offer(nearest.edge, closest_point(from, to, p).squared);
  }
  return nearest;
}

void expect_as_exact(const Scene2& scene, const ScenePick2& picks, const Place2& place, double reach) {
  const Point2 p{Rational(place[0]), Rational(place[1])};
  const NearestOfAll exact = nearest_of_all(scene, p);
  const Pick2 pick = picks.at(place, reach);
  const double reach_squared = reach * reach, slack = 1 + 1e-9;
  const double vertex = to_double(exact.vertex), edge = to_double(exact.edge);
  ASSERT_TRUE(pick.vertex || vertex > reach_squared / slack);
  ASSERT_TRUE(pick.surface || edge > reach_squared / slack);
  if (pick.vertex) {
    EXPECT_LE(to_double(squared_distance(*pick.vertex, p)), vertex * slack);
    EXPECT_LE(vertex, reach_squared * slack);
    EXPECT_NEAR(pick.vertex_distance * pick.vertex_distance, vertex, 1e-9 * vertex);
  }
  if (!pick.surface) return;
  const auto& [from, to] = scene.edges[*pick.surface];
  const ClosestPoint2 closest = closest_point(from, to, p);
  EXPECT_LE(std::sqrt(to_double(closest.squared)), std::sqrt(edge) * slack + 1.1e-6 * reach);
  EXPECT_LE(edge, reach_squared * slack);
  EXPECT_NEAR(pick.distance, std::sqrt(to_double(closest.squared)), 1e-9 * reach);
  const Rational t = std::clamp(position_on({from, to}, p), Rational(0), Rational(1));
  EXPECT_NEAR(pick.t, to_double(t), 1e-9);
  EXPECT_EQ(pick.is_last, pick.t > 0.5);
  const Rational cross = (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x);
  EXPECT_EQ(pick.face, (Face{*pick.surface, cross > 0}));
}

TEST(ScenePick2, IsTheNearestOfAllInRationals) {
  std::mt19937_64 random(5);
  std::vector<Scene2> scenes{small_room(), read_scene_2(showcase("apartment")), read_scene_2(showcase("museum"))};
  GeneratorRequest2 request;
  request.kind = "clutter";
  scenes.push_back(generate_2(request));
  for (const Scene2& scene : scenes) {
    const ScenePick2 picks(scene);
    double low = to_double(scene.edges[0].from.x), high = low;
    for (const Edge2& edge : scene.edges)
      for (const Rational& c : {edge.from.x, edge.from.y}) {
        low = std::min(low, to_double(c));
        high = std::max(high, to_double(c));
      }
    const auto coordinate = [&] { return low + (high - low) * (static_cast<double>(random() % 10'007) / 10'006); };
    for (int k = 0; k < 300; ++k)
      expect_as_exact(scene, picks, {coordinate(), coordinate()}, (high - low) / (k % 2 ? 10 : 100));
  }
}

TEST(ScenePick2, FindsNothingOutOfReach) {
  const Scene2 scene = small_room();
  const Pick2 pick = ScenePick2(scene).at({1.5, 1.5}, 0.4);
  EXPECT_FALSE(pick.vertex);
  EXPECT_FALSE(pick.surface);
  const Scene2 empty;
  EXPECT_FALSE(ScenePick2(empty).at({0, 0}, 1).surface);
}

TEST(ScenePick2, SaysTheSideExactly) {
  const Scene2 scene = small_room();
  const ScenePick2 picks(scene);
  EXPECT_EQ(picks.at({0.01, 1.5}, 0.1).face, (Face{1, false}));  // room[0]: the room is to its right
  EXPECT_EQ(picks.at({-0.01, 1.5}, 0.1).face, (Face{1, true}));
  EXPECT_EQ(picks.at({0, 1.5}, 0.1).face, (Face{1, false}));
  EXPECT_EQ(picks.at({-5e-324, 1.5}, 0.1).face, (Face{1, true}));
}

TEST(ScenePick2, PrefersTheFrontOfAThinWallListedTwice) {
  SceneBuilder2 builder;
  builder.add_material("white");
  builder.add_edge("left", {0, 0}, {"1/3", 3}, "white").add_edge("right", {"1/3", 3}, {0, 0}, "white");
  const Scene2 scene = builder.build();
  const ScenePick2 picks(scene);
  EXPECT_EQ(picks.at({0.4, 1.5}, 1).face, (Face{0, false}));
  EXPECT_EQ(picks.at({0.0, 1.5}, 1).face, (Face{1, false}));
}

TEST(ScenePick2, PrefersTheFrontWithinAMillionthOfTheReachOnly) {
  for (const auto& [apart, picked] : {std::pair<const char*, std::uint32_t>{"1e-9", 1}, {"1e-3", 0}}) {
    SceneBuilder2 builder;
    builder.add_material("white");
    builder.add_edge("looks right", {0, 0}, {0, 3}, "white").add_edge("looks left", {apart, 3}, {apart, 0}, "white");
    const Scene2 scene = builder.build();
    EXPECT_EQ(ScenePick2(scene).at({-0.1, 1.5}, 1).surface, picked) << apart;
  }
}

TEST(ScenePick2, PrefersTheWallThatIsSeenBeyondACorner) {
  const Scene2 scene = small_room();
  // Beyond the corner (3, 1) of the table both its sides are as near; the place is before table[0] or table[1].
  const Pick2 pick = ScenePick2(scene).at({3.1, 0.9}, 0.3);
  EXPECT_FALSE(pick.face.is_back);
  EXPECT_EQ(pick.surface, 7u);
  EXPECT_TRUE(pick.is_last);
  EXPECT_EQ(pick.t, 1);
}

TEST(ScenePick2, PicksAnEdgeOfLengthZero) {
  Scene2 scene = small_room();
  scene.edges[0].to = scene.edges[0].from;
  const Pick2 pick = ScenePick2(scene).at({1.01, 1}, 0.1);
  EXPECT_EQ(pick.surface, 0u);
  EXPECT_EQ(pick.t, 0);
  EXPECT_NEAR(pick.distance, 0.01, 1e-12);
}

TEST(ScenePick2, FindsWhatLiesWhollyInARectangle) {
  const Scene2 scene = small_room();
  const ScenePick2 picks(scene);
  EXPECT_THAT(picks.in_rectangle({0.5, 0.9}, {3.5, 2.5}), ElementsAre(0, 7, 8, 9, 10));
  EXPECT_THAT(picks.in_rectangle({3, 2}, {2, 1}), ElementsAre(7, 8, 9, 10));
  EXPECT_THAT(picks.in_rectangle({2.1, 0.5}, {9, 2.5}), ElementsAre(5, 8));
  EXPECT_THAT(picks.in_rectangle({1.2, 1.2}, {1.8, 1.8}), IsEmpty());
}

}  // namespace
}  // namespace hottel::pick_test

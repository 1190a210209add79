#include "viewer/edit/plane/snapping.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "geometry/plane/scene/closest_point.h"
#include "kernel/support/failure.h"
#include "tests/viewer/edit/plane/edited_scenes.h"

namespace hottel::snapping_test {
namespace {

using To = Snap2::To;

SnapRequest2 within(double reach, int decimals = 1) {
  SnapRequest2 request;
  request.reach = reach;
  request.decimals = decimals;
  return request;
}

Rational decimal(const char* text) { return *parse_rational(text); }

// A slanted wall from (0, 0) to (3, 4).
Scene2 slanted_wall() {
  SceneBuilder2 builder;
  builder.add_material("white").add_edge("wall", {0, 0}, {3, 4}, "white");
  return builder.build();
}

// Whether the point lies on the closed segment, exactly.
bool is_on(const Edge2& e, const Point2& p) {
  return (e.to.x - e.from.x) * (p.y - e.from.y) == (e.to.y - e.from.y) * (p.x - e.from.x) &&
         std::min(e.from.x, e.to.x) <= p.x && p.x <= std::max(e.from.x, e.to.x) && std::min(e.from.y, e.to.y) <= p.y &&
         p.y <= std::max(e.from.y, e.to.y);
}

TEST(Snapper2, TakesDecimalsWhereNothingIsNear) {
  const Snap2 snap = snapped(small_room(), {1.4449, 0.7501}, within(0.1));
  EXPECT_EQ(snap.to, To::kDecimals);
  EXPECT_EQ(snap.at, (Point2{decimal("1.4"), decimal("0.8")}));
  EXPECT_EQ(snap.surface, std::nullopt);
  EXPECT_EQ(snapped(Scene2{}, {12, -17}, within(1, -1)).at, (Point2{10, -20}));
}

TEST(Snapper2, PrefersAVertexToANearerEdge) {
  const Snap2 snap = snapped(small_room(), {3.96, 2.7}, within(0.4));
  EXPECT_EQ(snap.to, To::kVertex);
  EXPECT_EQ(snap.at, (Point2{4, 3}));
  EXPECT_EQ(snap.surface, 2u);
  EXPECT_EQ(snapped(small_room(), {3.96, 2.7}, within(0.1)).to, To::kEdge);
}

TEST(Snapper2, TakesTheNearestVertex) {
  EXPECT_EQ(snapped(small_room(), {2.6, 1.2}, within(5)).at, (Point2{3, 1}));
  EXPECT_EQ(snapped(small_room(), {2.4, 1.2}, within(5)).at, (Point2{2, 1}));
}

TEST(Snapper2, TakesDecimalsAlongAnEdgeOfAnAxisAsFarAsItGoes) {
  const Snap2 wall = snapped(small_room(), {0.02, 1.2345}, within(0.1, 2));
  EXPECT_EQ(wall.to, To::kEdge);
  EXPECT_EQ(wall.at, (Point2{0, decimal("1.23")}));
  EXPECT_EQ(wall.surface, 1u);
  EXPECT_EQ(snapped(small_room(), {3.4, 0.52}, within(0.1, 0)).at, (Point2{3, decimal("0.5")}));
  SnapRequest2 edges_only = within(0.1, -1);
  edges_only.to_vertices = false;
  EXPECT_EQ(snapped(small_room(), {3.9, 0.52}, edges_only).at, (Point2{3, decimal("0.5")}));
}

TEST(Snapper2, TakesAShortDecimalOfTheWayAlongASlantedEdge) {
  const Snap2 snap = snapped(slanted_wall(), {1.0, 1.3}, within(0.2, 1));
  EXPECT_EQ(snap.to, To::kEdge);
  // t = 0.328: the length along an axis is at most 10, so that two digits make steps of at most a tenth.
  EXPECT_EQ(snap.at, (Point2{decimal("0.99"), decimal("1.32")}));
}

TEST(Snapper2, PutsPointsExactlyOnEdges) {
  std::mt19937_64 random(3);
  const auto number = [&]() -> Rational {
    return (Rational(static_cast<long>(random() % 20'000)) - 10'000) / (random() % 2 ? 1000 : 7);
  };
  SceneBuilder2 builder;
  builder.add_material("white");
  for (int k = 0; k < 40; ++k) builder.add_edge("", {number(), number()}, {number(), number()}, "white");
  for (int k = 0; k < 10; ++k) builder.add_edge("", {k, number()}, {k, number()}, "white");
  const Scene2 scene = builder.build();
  const Snapper2 snapper(scene);
  std::size_t on_edges = 0;
  for (int k = 0; k < 4000; ++k) {
    const Place2 place{to_double(number()), to_double(number())};
    SnapRequest2 request = within(1, static_cast<int>(random() % 6) - 1);
    request.to_vertices = k % 2 == 0;
    const Snap2 snap = snapper.at(place, request);
    if (snap.to != To::kEdge) continue;
    ++on_edges;
    const Edge2& edge = scene.edges[*snap.surface];
    ASSERT_TRUE(is_on(edge, snap.at)) << k;
    // Along the edge it is off by at most a step of the decimals in each coordinate.
    const Point2 foot = closest_point(edge.from, edge.to, {Rational(place[0]), Rational(place[1])}).at;
    const Rational step = decimal(("1e" + std::to_string(-request.decimals)).c_str());
    if (request.decimals < 1) continue;  // t has one digit at least
    ASSERT_LE(squared_distance(foot, snap.at), step * step) << k;
  }
  EXPECT_GT(on_edges, 1000u);
}

TEST(Snapper2, LeavesOutWhatIsMoved) {
  SnapRequest2 request = within(0.5);
  request.moved = {7, 8, 9, 10};
  EXPECT_EQ(snapped(small_room(), {2.1, 1.1}, request).to, To::kDecimals);
  request.moved = {7, 8, 9};  // table[3] ends at (2, 1)
  EXPECT_EQ(snapped(small_room(), {2.1, 1.1}, request).to, To::kVertex);
  request.moved = {11};
  EXPECT_THROW(snapped(small_room(), {2, 1}, request), ContractViolation);
}

TEST(Snapper2, SnapsToNothingThatIsOff) {
  SnapRequest2 request = within(0.5);
  request.to_vertices = false;
  EXPECT_EQ(snapped(small_room(), {3.9, 2.9}, request).to, To::kEdge);
  request.to_edges = false;
  EXPECT_EQ(snapped(small_room(), {3.9, 2.9}, request).to, To::kDecimals);
}

TEST(Snapper2, SnapsInScenesOfAnySizeAndFarAway) {
  for (const char* scale : {"1e-200", "1e-9", "1e200"}) {
    const Rational factor = decimal(scale), far = factor * 1'000'000;
    Scene2 scene = slanted_wall();
    for (Point2* p : {&scene.edges[0].from, &scene.edges[0].to}) *p = {p->x * factor + far, p->y * factor};
    const Place2 place{to_double(factor * decimal("2.9") + far), to_double(factor * decimal("4.05"))};
    const double unit = to_double(factor);
    EXPECT_EQ(snapped(scene, place, within(0.3 * unit, 0)).at, scene.edges[0].to) << scale;
    EXPECT_EQ(snapped(scene, place, within(0.01 * unit, 0)).to, To::kDecimals) << scale;
  }
}

}  // namespace
}  // namespace hottel::snapping_test

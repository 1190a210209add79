// Vertices found by boxes, against a look at all of them; and what hemicubes claim with their help.
#include "solver/plane/methods/place_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "geometry/plane/generate/generators.h"
#include "io/scene/scene_json.h"
#include "solver/plane/methods/method_catalogue.h"
#include "tests/solver/plane/exact_radiosity.h"

namespace hottel::place_tree_test {
namespace {

PreparedScene2 scene_number(std::uint64_t seed) {
  return prepare(testing_radiosity::random_scene(seed), seed % 2 == 0 ? Divided2::kYes : Divided2::kNo);
}

TEST(PlaceTree2, VisitsEveryVertexThatDoesNotLieBehindARun) {
  std::size_t visited = 0, before = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const PreparedScene2 prepared = scene_number(seed);
    const Vertices2& vertices = prepared.arrangement.vertices();
    const ElementGeometry2 geometry(prepared);
    const PlaceTree2 tree(geometry, vertices.size());
    for (const ElementRun2& run : geometry.all_runs()) {
      std::set<VertexId> found;
      EXPECT_TRUE(tree.visit_before(run, [&](VertexId v) { return found.insert(v).second; }));
      for (const VertexId v : vertices.ids()) {
        if (vertices.orientation(run.ends.a, run.ends.b, v) > 0) continue;
        ++before;
        EXPECT_TRUE(found.contains(v)) << seed;
      }
      visited += found.size();
    }
  }
  EXPECT_GT(before, 1000u);
  EXPECT_GE(visited, before);
}

TEST(PlaceTree2, VisitsEveryVertexNearASegment) {
  std::size_t near = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const PreparedScene2 prepared = scene_number(seed);
    const Vertices2& vertices = prepared.arrangement.vertices();
    const ElementGeometry2 geometry(prepared);
    const PlaceTree2 tree(geometry, vertices.size());
    for (const double distance : {0.0, 1e-3, 0.2})
      for (const Segment2& piece : prepared.arrangement.pieces()) {
        const LocalPoint2& from = geometry.place(piece.a);
        const LocalVector2 along = geometry.place(piece.b) - from;
        std::set<VertexId> found;
        tree.visit_near(from, along, distance, [&](VertexId v) { return found.insert(v).second; });
        for (const VertexId v : vertices.ids()) {
          const LocalVector2 way = geometry.place(v) - from;
          const double t = std::clamp(dot(way, along) / dot(along, along), 0.0, 1.0);
          if (length({way.x - t * along.x, way.y - t * along.y}) > distance) continue;
          ++near;
          EXPECT_TRUE(found.contains(v)) << seed;
        }
      }
  }
  EXPECT_GT(near, 1000u);
}

Scene2 polygon_seen_from_outside(int n) {
  Scene2 scene = testing_radiosity::convex_polygon(n);
  for (Edge2& surface : scene.edges) std::swap(surface.from, surface.to);
  return scene;
}

TEST(PlaceTree2, VisitsFewWhereFewLieBeforeOrNear) {
  const PreparedScene2 prepared = prepare(polygon_seen_from_outside(2000));
  const ElementGeometry2 geometry(prepared);
  const PlaceTree2 tree(geometry, prepared.arrangement.vertices().size());
  std::size_t visited = 0, runs = 0;
  const auto count = [&](VertexId) { return ++visited > 0; };
  for (std::uint32_t i = 0; i < geometry.count(); ++i)
    for (const ElementRun2& run : geometry.runs(i)) {
      if (!geometry.has_row(i)) continue;
      ++runs;
      tree.visit_before(run, count);
      tree.visit_near(run.from, run.to - run.from, 1e-9, count);
    }
  EXPECT_EQ(runs, 2000u);
  EXPECT_LT(visited, runs * prepared.arrangement.vertices().size() / 10);
}

TEST(PlaceTree2, StopsWhenToldTo) {
  const PreparedScene2 prepared = scene_number(3);
  const ElementGeometry2 geometry(prepared);
  const PlaceTree2 tree(geometry, prepared.arrangement.vertices().size());
  int visited = 0;
  EXPECT_FALSE(tree.visit_before(geometry.all_runs().front(), [&](VertexId) { return ++visited < 2; }));
  EXPECT_EQ(visited, 2);
}

// What a hemicube claims, by the formula of hemicube.cpp and all vertices.
std::optional<double> claimed_by_all_vertices(const PreparedScene2& prepared, double resolution) {
  const Vertices2& vertices = prepared.arrangement.vertices();
  const ElementGeometry2 geometry(prepared);
  double largest = 0;
  for (std::uint32_t i = 0; i < geometry.count(); ++i) {
    double error = 1e-9;
    for (const ElementRun2& run : geometry.runs(i)) {
      if (!geometry.has_row(i)) continue;
      for (const VertexId v : vertices.ids()) {
        if (vertices.is_between(run.ends.a, run.ends.b, v)) return std::nullopt;
        if (vertices.orientation(run.ends.a, run.ends.b, v) >= 0) continue;
        const LocalVector2 p = geometry.place(v) - run.centre;
        const double x = dot(p, run.direction), y = dot(p, run.normal());
        const double r = std::hypot(std::max(0.0, std::abs(x) - run.length / 2), y);
        error += run.share * (0.5 / resolution + 2 * resolution * 0x1p-34 + run.length / 8 * y * y / (r * r * r));
      }
    }
    largest = std::max(largest, error);
  }
  for (const Segment2& piece : prepared.arrangement.pieces())
    for (const VertexId v : vertices.ids()) {
      if (v == piece.a || v == piece.b) continue;
      const LocalVector2 along = geometry.place(piece.b) - geometry.place(piece.a),
                         way = geometry.place(v) - geometry.place(piece.a);
      const double t = std::clamp(dot(way, along) / dot(along, along), 0.0, 1.0);
      if (length({way.x - t * along.x, way.y - t * along.y}) <= 0x1p-16 * geometry.diagonal()) return std::nullopt;
    }
  return largest < 1 ? std::optional(largest) : std::nullopt;
}

TEST(Hemicube2, ClaimsWhatAllVerticesTell) {
  int claims = 0, others = 0;
  const auto compare = [&](Scene2 scene) {
    const PreparedScene2 prepared = prepare(std::move(scene), Divided2::kYes);
    for (const int resolution : {64, 1024}) {
      const auto claimed = methods_2().make("hemicube:" + std::to_string(resolution))->declared_error(prepared);
      const auto expected = claimed_by_all_vertices(prepared, resolution);
      ASSERT_EQ(claimed.has_value(), expected.has_value()) << prepared.scene.about;
      ++(claimed ? claims : others);
      if (claimed) {
        EXPECT_NEAR(*claimed, *expected, 1e-9 * *expected) << prepared.scene.about;
      }
    }
  };
  for (std::uint64_t seed = 0; seed < 60; ++seed) compare(testing_radiosity::random_scene(seed));
  for (const int n : {3, 4, 7, 40, 200}) {
    compare(testing_radiosity::convex_polygon(n));
    compare(polygon_seen_from_outside(n));
  }
  EXPECT_GT(claims, 10);
  EXPECT_GT(others, 10);
}

}  // namespace
}  // namespace hottel::place_tree_test

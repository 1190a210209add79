// Which vertices see each other: boxes by count, and loose triangles against every segment and triangle.
#include "geometry/space/exchange/vertex_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "geometry/space/prepared/prepared_scene.h"
#include "io/scene/scene_json.h"

namespace hottel::vertex_graph_test {
namespace {

Scene3 scene_of(const std::vector<std::vector<Point3>>& polygons) {
  Scene3 scene;
  scene.materials.push_back({.name = "m", .reflectivity = {}, .emission = {}});
  scene.groups.emplace_back("all");
  for (const std::vector<Point3>& points : polygons) {
    Surface surface;
    surface.name = "p" + std::to_string(scene.surfaces.size());
    scene.add(surface, {points, {}});
  }
  return scene;
}

std::vector<std::vector<Point3>> box(bool is_solid) {
  std::vector<std::vector<Point3>> faces{
      {{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}, {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
      {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}, {{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}},
      {{1, 1, 0}, {0, 1, 0}, {0, 1, 1}, {1, 1, 1}}, {{0, 1, 0}, {0, 0, 0}, {0, 0, 1}, {0, 1, 1}}};
  if (!is_solid)
    for (std::vector<Point3>& face : faces) std::ranges::reverse(face);
  return faces;
}

std::size_t along_edges(const std::vector<VisiblePair3>& pairs) {
  return static_cast<std::size_t>(
      std::ranges::count_if(pairs, [](const VisiblePair3& pair) { return pair.along.has_value(); }));
}

TEST(VisibilityGraph3, OfARoomHasAllPairsAndOfASolidNoneThroughIt) {
  const auto room = visibility_graph_3(prepare(scene_of(box(false)))),
             solid = visibility_graph_3(prepare(scene_of(box(true))));
  EXPECT_EQ(room.size(), 28u);
  EXPECT_EQ(solid.size(), 24u);
  EXPECT_EQ(along_edges(room), 12u);
  EXPECT_EQ(along_edges(solid), 12u);
}

TEST(VisibilityGraph3, OfVerticesOnALineHasThoseThatFollowEachOther) {
  const auto triangle = [](int x) { return std::vector<Point3>{{x, 0, 0}, {x, 1, 1}, {x, -1, 1}}; };
  const auto pairs = visibility_graph_3(prepare(scene_of({triangle(0), triangle(1), triangle(2)})));
  const auto has = [&](std::uint32_t v, std::uint32_t w) {
    return std::ranges::any_of(pairs, [&](const VisiblePair3& pair) { return pair.v == v && pair.w == w; });
  };
  EXPECT_TRUE(has(0, 3));
  EXPECT_TRUE(has(3, 6));
  EXPECT_FALSE(has(0, 6));
}

int sign(const Rational& x) { return sgn(x); }
Rational volume(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return dot(cross(b - a, c - a), d - a);
}

// Whether a segment crosses a triangle; nothing is in a special position.
bool crosses(const Point3& a, const Point3& b, const std::vector<Point3>& t) {
  if (sign(volume(t[0], t[1], t[2], a)) == sign(volume(t[0], t[1], t[2], b))) return false;
  const int u = sign(volume(a, b, t[0], t[1]));
  return u == sign(volume(a, b, t[1], t[2])) && u == sign(volume(a, b, t[2], t[0]));
}

TEST(VisibilityGraph3, OfLooseTrianglesIsWhatEverySegmentAndTriangleTell) {
  std::mt19937_64 random(5);
  const auto number = [&] { return Rational(static_cast<long>(random() % 1000003)); };
  for (int k = 0; k < 6; ++k) {
    std::vector<std::vector<Point3>> triangles(7);
    for (auto& triangle : triangles)
      for (int c = 0; c < 3; ++c) triangle.push_back({number(), number(), number()});
    std::vector<VisiblePair3> slow;
    const auto corner = [&](std::uint32_t v) -> const Point3& { return triangles[v / 3][v % 3]; };
    for (std::uint32_t v = 0; v < 21; ++v)
      for (std::uint32_t w = v + 1; w < 21; ++w) {
        bool is_free = true;
        for (std::uint32_t t = 0; t < 7; ++t)
          is_free &= t == v / 3 || t == w / 3 || !crosses(corner(v), corner(w), triangles[t]);
        if (is_free) slow.push_back({v, w, v / 3 == w / 3 ? std::optional(v / 3) : std::nullopt});
      }
    EXPECT_EQ(visibility_graph_3(prepare(scene_of(triangles))), slow) << k;
  }
}

}  // namespace
}  // namespace hottel::vertex_graph_test

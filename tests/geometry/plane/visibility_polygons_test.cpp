// What many points see: corners against those of VisibilityPolygon2, which are rationals.
#include "geometry/plane/visibility/visibility_polygons.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "geometry/plane/generate/generators.h"
#include "geometry/plane/visibility/visibility_polygon.h"
#include "io/scene/scene_json.h"
#include "kernel/support/interrupt.h"
#include "kernel/support/parallel.h"

namespace hottel::visibility_polygons_test {
namespace {

Scene2 generated(const std::string& kind, std::uint64_t n, int digits = 0) {
  GeneratorRequest2 request;
  request.kind = kind;
  request.n = n;
  request.seed = 5;
  if (digits > 0) request.digits = digits;
  return generate_2(request);
}

Rational fraction(std::uint64_t p, long q) {
  Rational value(static_cast<long>(p), q);
  value.canonicalize();
  return value;
}

// Points of a scene: its vertices, points on its edges, and points between and around its vertices, of several kinds.
std::vector<Point2> points_of(const Scene2& scene, std::size_t count) {
  std::mt19937_64 chance(7);
  const auto any_end = [&]() -> const Point2& {
    const Edge2& edge = scene.edges[chance() % scene.edges.size()];
    return chance() % 2 == 0 ? edge.from : edge.to;
  };
  std::vector<Point2> points;
  for (std::size_t k = 0; k < count; ++k) {
    const Point2 &p = any_end(), &q = any_end(), &r = any_end();
    const Edge2& edge = scene.edges[chance() % scene.edges.size()];
    const Rational s = fraction(chance() % 7, 6), t = fraction(chance() % 97, 89);
    switch (k % 5) {
      case 0:
        points.push_back({p.x + (q.x - p.x) / 2 + (r.x - p.x) / 4, p.y + (q.y - p.y) / 2 + (r.y - p.y) / 4});
        break;
      case 1:  // in line with two vertices
        points.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
        break;
      case 2:  // on an edge, at its end, or beyond it
        points.push_back(point_at(edge, s));
        break;
      case 3:
        points.push_back({Rational(to_double(p.x) * 0.7 + to_double(q.x) * 0.3),
                          Rational(to_double(q.y) * 0.6 + to_double(r.y) * 0.4)});
        break;
      default:
        points.push_back(p);
    }
  }
  return points;
}

// Bit for bit the nearest doubles, in the same order, with the face that is seen.
void expect_oracle(const PreparedScene2& prepared, const Point2& eye, const RoundedPolygon2& found) {
  const Arrangement2& arrangement = prepared.arrangement;
  const PointLocation2 location(arrangement.vertices(), arrangement.triangulation());
  const VisibilityPolygon2 polygon = visibility_polygon(arrangement, location, eye);
  const std::vector<Point2> corners = polygon.corners();
  const std::string where = to_string(eye.x) + ", " + to_string(eye.y);
  EXPECT_EQ(found.solid, polygon.solid) << where;
  ASSERT_EQ(found.corners.size(), corners.size()) << where;
  ASSERT_EQ(found.exact, corners) << where;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(found.corners[k].x), std::bit_cast<std::uint64_t>(to_double(corners[k].x)))
        << where << ": " << corners[k].x;
    EXPECT_EQ(std::bit_cast<std::uint64_t>(found.corners[k].y), std::bit_cast<std::uint64_t>(to_double(corners[k].y)))
        << where << ": " << corners[k].y;
  }
  // Every free part begins at some corner, and that corner says what is seen.
  for (const auto& part : polygon.parts) {
    if (part.solid != Solids2::kNone) continue;
    const auto place = std::find(corners.begin(), corners.end(), part.from);
    ASSERT_NE(place, corners.end()) << where;
    EXPECT_EQ(found.corners[static_cast<std::size_t>(place - corners.begin())].after, part.side) << where;
  }
}

void expect_oracle_everywhere(Scene2 scene, std::size_t count) {
  const std::vector<Point2> points = points_of(scene, count);
  const PreparedScene2 prepared = prepare(std::move(scene));
  const auto found = visibility_polygons(prepared, points, {.wants_exact = true});
  ASSERT_EQ(found.size(), points.size());
  for (std::size_t k = 0; k < points.size(); ++k) expect_oracle(prepared, points[k], found[k]);
}

TEST(VisibilityPolygons2, CornersAreTheNearestDoublesInTheOrderOfTheRationalOnes) {
  for (const char* kind : {"room", "clutter", "lattice", "maze", "comb", "star", "pillars", "plates"}) {
    SCOPED_TRACE(kind);
    expect_oracle_everywhere(generated(kind, 60), 100);
  }
}

TEST(VisibilityPolygons2, AreThoseOfScenesWithManyDigits) {
  for (const int digits : {9, 14, 17}) {
    SCOPED_TRACE(digits);
    expect_oracle_everywhere(generated("clutter", 60, digits), 60);
  }
}

TEST(VisibilityPolygons2, AreThoseOfDegenerateScenesWithPointsOnEdgesVerticesAndInSolids) {
  std::size_t scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(HOTTEL_SOURCE_DIR "/scenes/degenerate")) {
    if (entry.path().extension() != ".json") continue;
    SCOPED_TRACE(entry.path().filename());
    expect_oracle_everywhere(read_scene_2(entry.path().string()), 40);
    ++scenes;
  }
  EXPECT_GT(scenes, 30u);
}

// A wall behind a tip, so that the corner on it can be put anywhere.
struct Wall {
  explicit Wall(const std::string& wall)
      : prepared(prepare(parse_scene_2(R"({"hottel": 1, "dimension": 2, "materials": {"m": {}}, "edges": [
          {"name": "tip", "points": [[0, 1], [0, -5]], "material": "m"},
          {"name": "wall", "points": )" + wall +
                                           R"(, "material": "m"}]})",
                                       "wall.json"))),
        polygons(prepared.arrangement) {}
  RoundingCounts2 look(const Point2& eye) {
    RoundingCounts2 counts;
    RoundedPolygon2 polygon;
    polygons.look(eye, true, polygon, counts);
    for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
      EXPECT_EQ(polygon.corners[k].x, to_double(polygon.exact[k].x));
      EXPECT_EQ(polygon.corners[k].y, to_double(polygon.exact[k].y));
    }
    return counts;
  }
  PreparedScene2 prepared;
  VisibilityPolygons2 polygons;
};

TEST(CornerRounding2, FilterDecidesOrdinaryCornersAndExactOnesOnWallsAlongAnAxis) {
  Wall slanted("[[3, 7], [5, -7]]"), upright("[[3, 7], [3, -7]]");
  EXPECT_EQ(slanted.look({-3, 0}).filtered, 1u);
  EXPECT_EQ(slanted.look({-3, 0}).exact, 0u);
  EXPECT_EQ(upright.look({-3, 0}).exact, 0u);
  EXPECT_EQ(upright.look({Rational(-1, 3), Rational(1, 7)}).exact, 0u);
}

// A few edges with coordinates of up to so many bits, over some denominator, far from the origin or near it.
Scene2 edges_of_bits(std::mt19937_64& chance, int bits) {
  Scene2 scene;
  scene.materials.push_back({"black", {}, {}});
  const long denominators[] = {1, 3, 10, 1000, 1 << 20, 7 * 11 * 13};
  const long denominator = denominators[chance() % 6];
  const Rational far = fraction(chance() % 1000, 7) * static_cast<long>(chance() % 3) * 1000;
  const auto coordinate = [&] { return Rational(far + fraction(chance() >> (64 - bits), denominator)); };
  for (std::uint32_t k = 0; k < 8; ++k) {
    Surface surface;
    surface.name = "edge" + std::to_string(k);
    surface.group = k;
    const Point2 from{coordinate(), coordinate()}, to{coordinate(), coordinate()};
    if (from == to) continue;
    scene.groups.push_back(surface.name);
    surface.group = static_cast<std::uint32_t>(scene.groups.size() - 1);
    scene.add(std::move(surface), {from, to});
  }
  return scene;
}

TEST(CornerRounding2, Consistency) {
  std::mt19937_64 chance(3);
  RoundingCounts2 counts;
  for (int bits = 2; bits <= 62; ++bits)
    for (int round = 0; round < 6; ++round) {
      Scene2 scene = edges_of_bits(chance, bits);
      if (scene.edges.empty()) continue;
      const std::vector<Point2> points = points_of(scene, 12);
      const PreparedScene2 prepared = prepare(std::move(scene));
      const VisibilityPolygons2 polygons(prepared.arrangement);
      RoundedPolygon2 polygon;
      for (const Point2& point : points) {
        polygons.look(point, true, polygon, counts);
        for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
          ASSERT_EQ(polygon.corners[k].x, to_double(polygon.exact[k].x)) << bits << " bits";
          ASSERT_EQ(polygon.corners[k].y, to_double(polygon.exact[k].y)) << bits << " bits";
        }
      }
    }
  EXPECT_GT(counts.filtered, 5 * counts.exact);
  EXPECT_GT(counts.exact, 0u);
}

TEST(CornerRounding2, TiesZerosAndEyesOfManyDigitsAreDecidedExactly) {
  // Through the tip (0, 1) from (-1, y) the wall x = 1 is met at 2 - y: half-way between two doubles for this y.
  Wall upright("[[1, 700], [1, -7]]");
  const Rational tie = scaled_by_power_of_two(Rational(1), -53);
  EXPECT_EQ(upright.look({-1, Rational(1) - tie}).exact, 1u);
  // The wall crosses the axis at x = 5, and the ray through the tip meets it there: y = 0.
  Wall slanted("[[3, 7], [7, -7]]");
  EXPECT_EQ(slanted.look({-5, 2}).exact, 1u);
  Rational fine(1, 3);
  for (int k = 0; k < 6; ++k) fine *= fine;
  EXPECT_EQ(slanted.look({-3, fine}).exact, 1u);
}

// Edges at random that cross each other: most vertices are quotients, and the scene has no small integer form.
Scene2 crossing_edges(std::size_t count) {
  std::mt19937_64 chance(11);
  Scene2 scene;
  scene.materials.push_back({"black", {}, {}});
  const auto coordinate = [&] { return fraction(chance() % 1000003, 1000); };
  for (std::size_t k = 0; k < count; ++k) {
    Surface surface;
    surface.name = "edge" + std::to_string(k);
    surface.group = static_cast<std::uint32_t>(k);
    scene.groups.push_back(surface.name);
    const Point2 from{coordinate(), coordinate()};
    scene.add(std::move(surface), {from, {from.x + coordinate() / 3, from.y + coordinate() / 5 - 80}});
  }
  return scene;
}

TEST(VisibilityPolygons2, AreThoseOfScenesInWhichEdgesCross) { expect_oracle_everywhere(crossing_edges(40), 60); }

TEST(CornerRounding2, MostCornersAmongCrossingEdgesNeedNoRationals) {
  Scene2 scene = crossing_edges(40);
  const std::vector<Point2> points = points_of(scene, 60);
  const PreparedScene2 prepared = prepare(std::move(scene));
  ASSERT_FALSE(prepared.arrangement.vertices().is_small());
  const VisibilityPolygons2 polygons(prepared.arrangement);
  RoundingCounts2 counts;
  RoundedPolygon2 polygon;
  for (const Point2& point : points) polygons.look(point, false, polygon, counts);
  EXPECT_GT(counts.filtered, 100u);
  EXPECT_LT(counts.exact, counts.filtered);
}

TEST(VisibilityPolygons2, HaveTheSameBitsForAnyNumberOfThreads) {
  Scene2 scene = generated("clutter", 200);
  const std::vector<Point2> points = points_of(scene, 300);
  const PreparedScene2 prepared = prepare(std::move(scene));
  const auto many = visibility_polygons(prepared, points);
  const ThreadLimit one(1);
  const auto few = visibility_polygons(prepared, points);
  for (std::size_t k = 0; k < points.size(); ++k) EXPECT_EQ(many[k].corners, few[k].corners);
}

TEST(VisibilityPolygons2, TellHowFarTheyHaveComeAndStopWhereTheListenerThrows) {
  Scene2 scene = generated("clutter", 60);
  const std::vector<Point2> points = points_of(scene, 100);
  const PreparedScene2 prepared = prepare(std::move(scene));
  const ThreadLimit one(1);
  double last = 0;
  visibility_polygons(prepared, points, {.progress = [&](double fraction) { last = fraction; }});
  EXPECT_EQ(last, 1);
  EXPECT_THROW(visibility_polygons(prepared, points, {.progress = [](double) { throw Interrupted(); }}), Interrupted);
}

TEST(VisibilityPolygons2, HaveTheAreaOfTheRationalPolygonAndNoneUnderTheSky) {
  const PreparedScene2 room = prepare(generated("room", 20));
  const VisibilityPolygons2 polygons(room.arrangement);
  const Edge2 &a = room.scene.edges[0], &b = room.scene.edges[10];
  const Point2 eye{(a.from.x + b.from.x) / 2, (a.from.y + b.from.y) / 2};
  EXPECT_EQ(polygons.area(eye), visibility_polygon(room.arrangement, polygons.location(), eye).area);
  const Point2 outside{1000000, 0};
  EXPECT_EQ(polygons.area(outside), std::nullopt);
  EXPECT_TRUE(polygons.of(outside).sees_sky());
}

}  // namespace
}  // namespace hottel::visibility_polygons_test

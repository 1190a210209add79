// Lines of corners that a body stops, held against rational points and against what the pair exchanges.
#include "geometry/space/between/stopped_lines.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "geometry/space/arrangement/whole_patch.h"
#include "geometry/space/pairs/pair_integrator.h"
#include "tests/geometry/space/box_faces.h"

namespace hottel::stopped_lines_test {
namespace {

using box_faces::Points;
using box_faces::polygons_of;

Point3 minus(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Rational dot_of(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Point3 cross_of(const Point3& a, const Point3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Point3 normal_of(const Points& polygon) {
  return cross_of(minus(polygon[1], polygon[0]), minus(polygon[2], polygon[0]));
}
Rational height(const Point3& p, const Points& over) { return dot_of(normal_of(over), minus(p, over[0])); }

// Where the line from p to q meets the plane of a polygon is within it, and between them.
bool stops(const Point3& p, const Point3& q, const Points& polygon) {
  const Rational before = height(p, polygon), beyond = height(q, polygon);
  if (!(before * beyond < 0)) return false;
  const Rational share = before / (before - beyond);
  const Point3 way = minus(q, p);
  const Point3 at{p.x + share * way.x, p.y + share * way.y, p.z + share * way.z};
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point3 side = minus(polygon[(k + 1) % polygon.size()], polygon[k]);
    if (!(dot_of(normal_of(polygon), cross_of(side, minus(at, polygon[k]))) > 0)) return false;
  }
  return true;
}

bool stops_lines(const Points& i, const Points& j, const Points& body) {
  for (const Point3& p : i)
    for (const Point3& q : j)
      if (height(p, j) > 0 && height(q, i) > 0 && stops(p, q, body)) return true;
  return false;
}

struct Scene {
  Occluders3 occluders;
  Patch3 i, j;
  explicit Scene(const std::vector<Points>& polygons)
      : occluders(polygons_of(polygons)), i(whole_patch(occluders, 0)), j(whole_patch(occluders, 1)) {}

  bool stops() const {
    PairGeometry3 bodies(occluders, i, j);
    return stops_lines_of_corners(bodies, bodies.add(occluders, 2));
  }
};

const Points kLow{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
const Points kHigh{{0, 0, 2}, {0, 2, 2}, {2, 2, 2}, {2, 0, 2}};

TEST(StopsLinesOfCorners, WhereOnePassesWithin) {
  EXPECT_TRUE(Scene({kLow, kHigh, {{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}}).stops());
}

// Lines of corners pass its sides, or what they leave is behind: none of these is told.
TEST(StopsLinesOfCorners, NotWhereTheyTouchItOrPassIt) {
  EXPECT_FALSE(Scene({kLow, kHigh, {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}}).stops());
  EXPECT_FALSE(Scene({kLow, kHigh, {{3, 0, 1}, {4, 0, 1}, {4, 1, 1}, {3, 1, 1}}}).stops());
  const Points turned{kHigh.rbegin(), kHigh.rend()};
  EXPECT_FALSE(Scene({kLow, turned, {{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}}).stops());
}

TEST(StopsLinesOfCorners, AreThoseThatRationalPointsTellAndThenSomethingIsHidden) {
  std::mt19937_64 engine(7);
  const auto triangle = [&](int low, int high) {
    const auto place = [&](int from, int to) { return Rational(std::uniform_int_distribution<int>(from, to)(engine)); };
    Points points;
    for (int k = 0; k < 3; ++k) {
      const Rational x = place(0, 4), y = place(0, 4);
      points.push_back({x, y, place(low, high)});
    }
    return points;
  };
  const auto is_flat = [](const Points& p) { return p[0].z == p[1].z && p[1].z == p[2].z; };
  int stopped = 0;
  for (int round = 0; round < 600; ++round) {
    const std::vector<Points> all{triangle(0, 1), triangle(4, 5), triangle(1, 4)};
    const auto is_thin = [](const Points& p) { return dot_of(normal_of(p), normal_of(p)) == 0; };
    if (std::any_of(all.begin(), all.end(), is_thin) || is_flat(all[2])) continue;
    const Scene scene(all);
    ASSERT_EQ(scene.stops(), stops_lines(all[0], all[1], all[2])) << round;
    if (!scene.stops()) continue;
    ++stopped;
    EXPECT_FALSE(PairIntegrator3(scene.occluders).measure(scene.i, scene.j).is_whole) << round;
  }
  EXPECT_GT(stopped, 20);
}

}  // namespace
}  // namespace hottel::stopped_lines_test

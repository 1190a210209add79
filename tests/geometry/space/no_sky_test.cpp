// Sides that see no sky, because closed shells are around them.
#include "geometry/space/sky/no_sky.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "geometry/space/arrangement/whole_patch.h"
#include "geometry/space/pairs/pair_integrator.h"
#include "tests/geometry/space/box_faces.h"

namespace hottel::no_sky_test {
namespace {

using box_faces::box;
using box_faces::operator+;
using box_faces::Points;
using box_faces::polygons_of;

Rational ratio(long p, long q) { return Rational(p) / q; }

class Scene {
 public:
  explicit Scene(const std::vector<Points>& polygons)
      : occluders_(polygons_of(polygons)),
        merged_(occluders_),
        boxes_(merged_.occluders()),
        stretches_(merged_.occluders(), boxes_),
        no_sky_(occluders_, merged_, stretches_),
        measurer_(occluders_) {}

  bool has(std::uint32_t polygon, bool is_back) const { return no_sky_.has(merged_.surface_of(polygon), is_back); }
  // (1): where it says so, and everything is walked, S = 0. Returns how many sides it is said of.
  int check() const {
    int said = 0;
    for (std::uint32_t s = 0; s < occluders_.size(); ++s)
      for (const bool is_back : {false, true}) {
        if (!has(s, is_back)) continue;
        ++said;
        const PairResult3 m = measurer_.measure(whole_patch(occluders_, s, is_back), Patch3::all_of_the_sky(),
                                                {.tolerance = 1e-9, .asks_hiders = false});
        EXPECT_EQ(m.bounds.upper, 0) << s << (is_back ? " back" : " front");
      }
    return said;
  }

 private:
  Occluders3 occluders_;
  MergedOccluders3 merged_;
  SurfaceBoxes3 boxes_;
  SurfaceStretches3 stretches_;
  NoSky3 no_sky_;
  PairIntegrator3 measurer_;
};

std::vector<Points> turned(std::vector<Points> polygons) {
  for (Points& points : polygons) std::reverse(points.begin() + 1, points.end());
  return polygons;
}

// A prism over an outline, from z = 0 to 2, fronts outward; floors of triangles are given.
std::vector<Points> prism(const Points& outline, const std::vector<std::array<std::size_t, 3>>& triangles) {
  std::vector<Points> all;
  const auto at = [&](std::size_t k, long z) {
    return Point3{outline[k % outline.size()].x, outline[k % outline.size()].y, z};
  };
  for (std::size_t k = 0; k < outline.size(); ++k) all.push_back({at(k, 0), at(k + 1, 0), at(k + 1, 2), at(k, 2)});
  for (const auto& [a, b, c] : triangles) {
    all.push_back({at(a, 2), at(b, 2), at(c, 2)});
    all.push_back({at(a, 0), at(c, 0), at(b, 0)});
  }
  return all;
}

// An L: no part of its boundary is a hull.
std::vector<Points> l_shaped_room() {
  return turned(prism({{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {2, 2, 0}, {2, 4, 0}, {0, 4, 0}},
                      {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}));
}

TEST(NoSky3, InARoomThatIsNotConvex) {
  const Scene scene(l_shaped_room());
  for (std::uint32_t s = 0; s < 14; ++s) {
    EXPECT_TRUE(scene.has(s, false)) << s;
    EXPECT_FALSE(scene.has(s, true)) << s;
  }
  EXPECT_EQ(scene.check(), 14);
}

TEST(NoSky3, WhicheverWayWallsAreTurned) {
  std::vector<Points> room = l_shaped_room();
  for (const std::size_t s : {0u, 3u, 7u}) std::reverse(room[s].begin() + 1, room[s].end());
  const Scene scene(room);
  for (std::uint32_t s = 0; s < 14; ++s) EXPECT_TRUE(scene.has(s, s == 0 || s == 3 || s == 7)) << s;
  EXPECT_EQ(scene.check(), 14);
}

// Corners typed to few digits: no wall is plane, each is two triangles, and some of their seams are ridges.
TEST(NoSky3, InARoomTypedToSixDigits) {
  std::vector<Points> room;
  const auto typed = [](const Point3& p) {
    const auto digits = [](const Rational& value) -> Rational {
      return Rational(Integer(std::lround(1e6 * to_double(value)))) / 1'000'000;
    };
    const Rational c = ratio(866025, 1'000'000), s = ratio(1, 2);
    return Point3{digits(c * p.x - s * p.y + p.z / 7), digits(s * p.x + c * p.y), digits(p.z - p.x / 7)};
  };
  for (const Points& quad : turned(box({0, 0, 0}, {4, 3, 2})))
    for (const std::array<std::size_t, 3>& t : {std::array<std::size_t, 3>{0, 1, 2}, {0, 2, 3}})
      room.push_back({typed(quad[t[0]]), typed(quad[t[1]]), typed(quad[t[2]])});
  room.push_back({{1, 1, ratio(1, 2)}, {ratio(3, 2), 1, ratio(1, 2)}, {1, ratio(3, 2), ratio(1, 2)}});
  const Scene scene(room);
  EXPECT_EQ(scene.check(), 14);
  EXPECT_TRUE(scene.has(12, false) && scene.has(12, true));
}

TEST(NoSky3, NotWhereAPolygonIsMissing) {
  const std::vector<Points> whole = l_shaped_room();
  for (std::size_t missing = 0; missing < whole.size(); ++missing) {
    std::vector<Points> room = whole;
    room.erase(room.begin() + static_cast<std::ptrdiff_t>(missing));
    EXPECT_EQ(Scene(room).check(), 0) << missing;
  }
}

TEST(NoSky3, InABoxAndNotBesideIt) {
  const Points inside{{ratio(1, 4), ratio(1, 4), ratio(1, 2)},
                      {ratio(3, 4), ratio(1, 4), ratio(1, 2)},
                      {ratio(1, 4), ratio(3, 4), ratio(1, 2)}};
  Points beside = inside, through = inside;
  for (Point3& p : beside) p.x = p.x + 1;
  through[1].x = ratio(11, 10);  // most of it within
  // Beside a box of which the hull of the scene is not made.
  const Scene scene(box({0, 0, 0}, {1, 1, 1}) +
                    std::vector<Points>{inside, beside, through, {{5, 5, 5}, {6, 5, 5}, {5, 6, 7}}});
  for (std::uint32_t s = 0; s < 6; ++s) {
    EXPECT_TRUE(scene.has(s, true)) << s;
    EXPECT_FALSE(scene.has(s, false)) << s;
  }
  for (const bool is_back : {false, true}) {
    EXPECT_TRUE(scene.has(6, is_back));
    EXPECT_FALSE(scene.has(7, is_back));
    EXPECT_FALSE(scene.has(8, is_back));
  }
  scene.check();
}

// Two that hang together at an edge which lies in a wall of the room: one within, one without.
TEST(NoSky3, OfWhatHangsTogetherThroughAWall) {
  const std::vector<Points> fin{{{2, 1, 3}, {2, 3, 3}, {3, 3, 5}, {3, 1, 5}},
                                {{2, 1, 3}, {1, 1, 2}, {1, 3, 2}, {2, 3, 3}}};
  std::vector<Points> room = turned(box({-2, 0, 0}, {2, 4, 6}));
  room.push_back({{9, 9, 9}, {10, 9, 9}, {9, 10, 11}});
  const Scene scene(room + fin);
  EXPECT_FALSE(scene.has(7, false) || scene.has(7, true));
  EXPECT_TRUE(scene.has(8, false) && scene.has(8, true));
  scene.check();
}

// A box on a floor that is not a part of it: the floor is outside of it, and below it.
TEST(NoSky3, NotOfAFloorOnWhichABoxStands) {
  const Scene scene(
      box({1, 1, 0}, {2, 2, 1}) +
      std::vector<Points>{{{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {0, 1, 0}},
                          {{3, 0, 2}, {4, 0, 2}, {3, 1, 3}},
                          {{0, 1, ratio(1, 2)}, {4, 1, ratio(1, 2)}, {4, 3, ratio(1, 2)}, {0, 3, ratio(1, 2)}}});
  EXPECT_FALSE(scene.has(6, false) || scene.has(6, true));
  EXPECT_FALSE(scene.has(8, false) || scene.has(8, true));
  scene.check();
}

// Two rooms that share a line are one shell by edges, and none that is asked.
TEST(NoSky3, OfShellsThatTouchAlongALine) {
  const Scene scene(box({0, 0, 0}, {1, 1, 1}) + box({1, 1, 0}, {2, 2, 1}) +
                    std::vector<Points>{{{5, 5, 5}, {6, 5, 5}, {5, 6, 7}}});
  scene.check();
  const Scene apart(box({0, 0, 0}, {1, 1, 1}) + box({1, 1, ratio(1, 2)}, {2, 2, 2}) +
                    std::vector<Points>{{{5, 5, 5}, {6, 5, 5}, {5, 6, 7}}});
  EXPECT_EQ(apart.check(), 12);
}

}  // namespace
}  // namespace hottel::no_sky_test

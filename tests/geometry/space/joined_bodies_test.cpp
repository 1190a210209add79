// Bodies that hide as one from a point: which are joined, and that they hide what is within their outline.
#include "geometry/space/between/joined_bodies.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "geometry/space/arrangement/whole_patch.h"
#include "tests/geometry/space/box_faces.h"
#include "tests/oracle/space/nearest_polygon.h"

namespace hottel::joined_bodies_test {
namespace {

using box_faces::box;
using box_faces::Points;
using box_faces::polygons_of;
using testing::IsEmpty;
using testing::SizeIs;
using testing::UnorderedElementsAre;

// Polygons between a patch far below and one far above, as bodies 2, 3 and so on.
class Scene {
 public:
  explicit Scene(const std::vector<Points>& polygons)
      : occluders_(polygons_of(with_patches(polygons))),
        i_(whole_patch(occluders_, 0)),
        j_(whole_patch(occluders_, 1)),
        bodies_(occluders_, i_, j_) {
    for (std::uint32_t s = 2; s < occluders_.size(); ++s) bodies_.add(occluders_, s);
  }

  std::vector<JoinedBodies3::Group> groups(const Point3& eye) const {
    std::vector<std::uint32_t> all;
    for (std::uint32_t body = 2; body < bodies_.count(); ++body) all.push_back(body);
    return groups(eye, all);
  }
  std::vector<JoinedBodies3::Group> groups(const Point3& eye, const std::vector<std::uint32_t>& list) const {
    const Vertices3& vertices = occluders_.vertices();
    std::vector<BoundedVector> toward;
    for (const PairGeometry3::Point& p : bodies_.points) {
      const auto way = [&](const Integer& place, const Rational& origin, const Rational& from) {
        return to_double(origin + vertices.scale() * place - from);
      };
      BoundedVector w{way(p.exact().x, vertices.origin().x, eye.x), way(p.exact().y, vertices.origin().y, eye.y),
                      way(p.exact().z, vertices.origin().z, eye.z)};
      w.size = std::max({std::fabs(w.x), std::fabs(w.y), std::fabs(w.z)});
      toward.push_back(w);
    }
    std::vector<JoinedBodies3::Group> result;
    JoinedBodies3 joined(bodies_);
    joined.join(list, toward, result);
    joined.join(list, toward, result);  // again, with what it kept
    return result;
  }

 private:
  static std::vector<Points> with_patches(const std::vector<Points>& polygons) {
    std::vector<Points> all{{{-9, -9, -90}, {9, -9, -90}, {9, 9, -90}, {-9, 9, -90}},
                            {{-9, -9, 90}, {-9, 9, 90}, {9, 9, 90}, {9, -9, 90}}};
    all.insert(all.end(), polygons.begin(), polygons.end());
    return all;
  }

  Occluders3 occluders_;
  Patch3 i_, j_;
  PairGeometry3 bodies_;
};

Rational ratio(long p, long q) { return Rational(p) / q; }

// A square of two triangles whose corner (0, 1) is at some height; the second one may be turned over.
std::vector<Points> bent_square(const Rational& height, bool is_turned = false) {
  std::vector<Points> result{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 0, 0}, {1, 1, 0}, {0, 1, height}}};
  if (is_turned) std::reverse(result[1].begin(), result[1].end());
  return result;
}

// A dish of triangles and quads around the z axis: `sides` of each, the rim at height 2.
std::vector<Points> dish() {
  const std::array<std::array<long, 2>, 8> circle{
      {{5, 0}, {4, 3}, {0, 5}, {-3, 4}, {-5, 0}, {-4, -3}, {0, -5}, {3, -4}}};
  std::vector<Points> result;
  for (std::size_t k = 0; k < circle.size(); ++k) {
    const auto at = [&](std::size_t place, long radius, const Rational& height) {
      const auto& [x, y] = circle[place % circle.size()];
      return Point3{ratio(radius * x, 5), ratio(radius * y, 5), height};
    };
    result.push_back({{0, 0, 0}, at(k, 1, ratio(1, 4)), at(k + 1, 1, ratio(1, 4))});
    result.push_back({at(k, 1, ratio(1, 4)), at(k, 2, 2), at(k + 1, 2, 2)});
    result.push_back({at(k, 1, ratio(1, 4)), at(k + 1, 2, 2), at(k + 1, 1, ratio(1, 4))});
  }
  return result;
}

// (1): whichever sides are their fronts.
TEST(JoinedBodies3, TwoTrianglesOfASquareThatIsNotPlaneAreOne) {
  for (const long p : {1, -1})
    for (const long q : {1'000'000, 10})
      for (const bool is_turned : {false, true})
        for (const long z : {5, -5}) {
          const auto groups = Scene(bent_square(ratio(p, q), is_turned)).groups({ratio(1, 3), ratio(1, 3), z});
          ASSERT_THAT(groups, SizeIs(1)) << p << '/' << q << ' ' << is_turned << ' ' << z;
          EXPECT_THAT(groups[0].bodies, UnorderedElementsAre(2, 3));
          ASSERT_THAT(groups[0].outline, SizeIs(4));
          for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(groups[0].outline[k].to, groups[0].outline[(k + 1) % 4].from);
          EXPECT_EQ(groups[0].facings[0], z > 0 ? 1 : -1);
        }
}

// Between the planes of both, one is seen from the front and the other one from behind.
TEST(JoinedBodies3, WhatIsSeenOnOneSideOfAnEdgeIsNotJoined) {
  EXPECT_THAT(Scene(bent_square(1)).groups({-4, 5, 1}), IsEmpty());
}

TEST(JoinedBodies3, AnLIsNotOne) {
  std::vector<Points> corners;
  for (const auto& [x, y] : {std::array<long, 2>{0, 0}, {1, 0}, {0, 1}})
    corners.push_back({{x, y, 0}, {x + 1, y, 0}, {x + 1, y + 1, 0}, {x, y + 1, 0}});
  for (const auto& group : Scene(corners).groups({ratio(1, 3), ratio(1, 2), 7})) {
    EXPECT_THAT(group.bodies, SizeIs(2));
    EXPECT_THAT(group.outline, SizeIs(4));
  }
}

TEST(JoinedBodies3, ADishIsItsRimFromBelowAndFromAbove) {
  const Scene scene(dish());
  for (const long z : {40, -40}) {
    const auto groups = scene.groups({ratio(1, 7), ratio(1, 9), z});
    ASSERT_THAT(groups, SizeIs(1)) << z;
    EXPECT_THAT(groups[0].bodies, SizeIs(24));
    EXPECT_THAT(groups[0].outline, SizeIs(8));
  }
}

// What is around the eye has an outline that is not around what it hides.
TEST(JoinedBodies3, ARoomIsNotWithinTheOutlineOfItsWindow) {
  std::vector<Points> room = box({-1, -1, -1}, {1, 1, 1});
  const Point3 eye{ratio(1, 7), ratio(1, 11), ratio(1, 13)};
  for (const auto& group : Scene(room).groups(eye)) EXPECT_LT(group.bodies.size(), 4u);
  room.erase(room.begin());
  for (const auto& group : Scene(room).groups(eye)) EXPECT_LT(group.bodies.size(), 4u);
}

TEST(JoinedBodies3, OnlyThoseOfTheListAreJoined) {
  const Scene scene(bent_square(ratio(1, 10)));
  EXPECT_THAT(scene.groups({ratio(1, 3), ratio(1, 3), 5}, {2}), IsEmpty());
  EXPECT_THAT(scene.groups({ratio(1, 3), ratio(1, 3), 5}, {}), IsEmpty());
}

// An edge of three: one of them stays alone.
TEST(JoinedBodies3, ASideIsSharedByTwo) {
  std::vector<Points> fins = bent_square(ratio(1, 10));
  fins.push_back({{0, 0, 0}, {1, 1, 0}, {0, 1, -1}});
  for (const auto& group : Scene(fins).groups({ratio(1, 3), ratio(1, 3), 5})) EXPECT_THAT(group.bodies, SizeIs(2));
}

// (2): against exact rays.
TEST(JoinedBodies3, AGroupHidesWhatIsWithinItsOutline) {
  std::mt19937_64 random(20);
  const auto below = [&](long count) { return static_cast<long>(random() % static_cast<std::uint64_t>(count)); };
  int joined = 0, within = 0, beside = 0;
  for (int round = 0; round < 60; ++round) {
    std::vector<Points> mesh = dish();
    for (Points& polygon : mesh)  // moves each corner a little, in all polygons that have it
      for (Point3& p : polygon) {
        const long key = static_cast<long>(std::lround(1000 * to_double(p.x) + 7000 * to_double(p.y)));
        p.z += ratio((key * (round + 3)) % 17 - 8, round % 2 == 0 ? 60 : 1'000'000);
      }
    const Point3 eye{ratio(below(600) - 300, 37), ratio(below(600) - 300, 41), ratio(below(600) - 300, 43)};
    const Scene scene(mesh);
    for (const JoinedBodies3::Group& group : scene.groups(eye)) {
      ++joined;
      std::vector<oracle::SpacePolygon> polygons;
      for (const std::uint32_t body : group.bodies) {
        oracle::SpacePolygon& polygon = polygons.emplace_back();
        for (const Point3& p : mesh[body - 2]) polygon.push_back({p.x, p.y, p.z});
      }
      std::vector<std::array<Point3, 2>> outline;
      for (const JoinedBodies3::Side& side : group.outline) {
        const Points& points = mesh[side.body - 2];
        const Point3 &a = points[side.side], &b = points[(side.side + 1) % points.size()];
        const auto at = static_cast<std::size_t>(std::ranges::find(group.bodies, side.body) - group.bodies.begin());
        outline.push_back(group.facings[at] < 0 ? std::array{a, b} : std::array{b, a});
      }
      const oracle::SpacePoint from{eye.x, eye.y, eye.z};
      const oracle::RayCaster cast(polygons, from);
      for (int k = 0; k < 40; ++k) {
        const oracle::SpacePoint at{ratio(below(500) - 250, 97), ratio(below(500) - 250, 89),
                                    ratio(below(300) - 50, 101)};
        const oracle::SpacePoint way = at - from;
        const oracle::NearestPolygon met = cast(way);
        if (!met.is_plain) continue;
        const bool is_within = std::ranges::all_of(outline, [&](const auto& side) {
          const oracle::SpacePoint a{side[0].x - eye.x, side[0].y - eye.y, side[0].z - eye.z},
              b{side[1].x - eye.x, side[1].y - eye.y, side[1].z - eye.z};
          return sgn(oracle::dot(oracle::cross(a, b), way)) > 0;
        });
        EXPECT_EQ(is_within, met.polygon >= 0) << round;
        ++(is_within ? within : beside);
      }
    }
  }
  EXPECT_GT(joined, 60);
  EXPECT_GT(within, 500);
  EXPECT_GT(beside, 500);
}

}  // namespace
}  // namespace hottel::joined_bodies_test

// What stretches are told of without maps: what is behind a solid, and where lines go past them.
#include "geometry/space/stretches/solid_cover.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "geometry/space/arrangement/whole_patch.h"
#include "geometry/space/stretches/stretch_hull.h"
#include "tests/geometry/space/box_faces.h"

namespace hottel::solid_cover_test {
namespace {

using box_faces::box;
using box_faces::operator+;
using box_faces::Points;
using box_faces::polygons_of;
using testing::Contains;
using testing::ElementsAre;
using testing::Not;
using testing::UnorderedElementsAre;

Rational ratio(long p, long q) { return Rational(p) / q; }

// Surface 0 is the patch, surface 1 what it is asked about; the others are all between, solids too.
class Scene {
 public:
  explicit Scene(const std::vector<Points>& polygons)
      : occluders_(polygons_of(polygons)),
        solids_(occluders_),
        i_(whole_patch(occluders_, 0)),
        j_(whole_patch(occluders_, 1)),
        bodies_(occluders_, i_, j_) {
    for (std::uint32_t s = 2; s < occluders_.size(); ++s) bodies_.add(occluders_, s);
    for (const ConvexBody3& body : solids_.bodies()) bodies_.add_solid(occluders_, body);
  }

  const PairGeometry3& bodies() const { return bodies_; }
  std::uint32_t solid(std::uint32_t number) const { return bodies_.count() + number; }

  // Between two points of the scene.
  Stretch3 stretch(const Point3& a, const Point3& b) const {
    const Vertices3& vertices = occluders_.vertices();
    const auto place = [&](const Point3& p) {
      const Rational x[] = {(p.x - vertices.origin().x) / vertices.scale(),
                            (p.y - vertices.origin().y) / vertices.scale(),
                            (p.z - vertices.origin().z) / vertices.scale()};
      const Integer common = lcm(lcm(x[0].get_den(), x[1].get_den()), x[2].get_den());
      return WeightedPoint3{{x[0].get_num() * (common / x[0].get_den()), x[1].get_num() * (common / x[1].get_den()),
                             x[2].get_num() * (common / x[2].get_den())},
                            common};
    };
    return stretch_between(place(a), place(b));
  }
  std::vector<std::uint32_t> narrowed(const Point3& a, const Point3& b, std::vector<std::uint32_t> list) const {
    SolidCover3(bodies_).narrow(stretch(a, b), 0, 1, list);
    return list;
  }

 private:
  Occluders3 occluders_;
  ConvexBodies3 solids_;
  Patch3 i_, j_;
  PairGeometry3 bodies_;
};

const std::vector<Points> kPatches{{{-9, -9, -9}, {-8, -9, -9}, {-9, -8, -9}},
                                   {{90, 90, 90}, {91, 90, 90}, {90, 91, 90}}};

// (1), (2): what is behind from both ends goes, and what comes to sight from one of them stays.
TEST(SolidCover3, LeavesOutWhatIsBehindFromAllOfTheStretch) {
  const Scene scene(kPatches + box({0, 0, 0}, {2, 2, 2}) + box({5, ratio(1, 2), ratio(1, 2)}, {6, 1, 1}) +
                    std::vector<Points>{{{7, ratio(1, 2), 1}, {7, ratio(3, 4), 1}, {7, 1, ratio(5, 4)}}});
  const std::uint32_t large = scene.solid(0), small = scene.solid(1), flat = 14;
  EXPECT_THAT(scene.narrowed({-1, 1, 1}, {-1, ratio(3, 2), 1}, {small, flat, large}), ElementsAre(large));
  EXPECT_THAT(scene.narrowed({-1, 1, 1}, {-1, 40, 1}, {small, flat, large}), UnorderedElementsAre(large, small, flat));
  // Before the large one the small ones are within its outline too.
  EXPECT_THAT(scene.narrowed({50, ratio(3, 4), ratio(3, 4)}, {50, ratio(3, 4), 1}, {large, small}),
              testing::SizeIs(testing::Le(2u)));
}

TEST(SolidCover3, SmallThingsBeforeALargeOneAreWithinItsOutline) {
  const Scene scene(kPatches + box({0, 0, 0}, {20, 20, 20}) + box({-2, 9, 9}, {-1, 10, 10}));
  EXPECT_THAT(scene.narrowed({-6, 9, 9}, {-6, 10, 10}, {scene.solid(0), scene.solid(1)}), ElementsAre(scene.solid(0)));
}

// One that hides all but nothing is no cover: what touches its outline stays.
TEST(SolidCover3, NotByAHair) {
  const Scene scene(kPatches + box({0, 0, 0}, {2, 2, 2}) + box({4, 0, 0}, {5, 2, 2}));
  EXPECT_THAT(scene.narrowed({-1, 0, 0}, {-1, 2, 2}, {scene.solid(0), scene.solid(1)}),
              ElementsAre(scene.solid(0), scene.solid(1)));
}

// From within its faces hide one by one, and some may not be there.
TEST(SolidCover3, NotByASolidThatTheStretchIsIn) {
  const Scene scene(kPatches + box({0, 0, 0}, {2, 2, 2}) + box({5, ratio(1, 2), ratio(1, 2)}, {6, 1, 1}));
  for (const auto& [a, b] : {std::pair<Point3, Point3>{{1, 1, 1}, {1, 1, ratio(3, 2)}}, {{-1, 1, 1}, {1, 1, 1}}})
    EXPECT_THAT(scene.narrowed(a, b, {scene.solid(0), scene.solid(1)}), Contains(scene.solid(1)));
}

// Along the ground a box without a bottom covers what stands behind it, and not what is below.
TEST(SolidCover3, WithinTheLidAlone) {
  std::vector<Points> open = box({0, 0, 0}, {2, 2, 2});
  open.erase(open.begin());
  const Scene scene(kPatches + open + box({5, ratio(1, 2), 0}, {6, 1, 1}) +
                    box({5, ratio(1, 2), ratio(-3, 2)}, {6, 1, -1}));
  const std::vector<std::uint32_t> all{scene.solid(0), scene.solid(1), scene.solid(2)};
  EXPECT_THAT(scene.narrowed({-1, ratio(1, 2), 0}, {-1, 1, 0}, all),
              UnorderedElementsAre(scene.solid(0), scene.solid(2)));
}

// Past an outline go only lines that come from the patch.
TEST(StretchHull3, WhatNoLineFromThePatchMeetsBeyondAStretchHidesNothing) {
  const std::vector<Points> patches{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                                    {{-90, -90, 90}, {-90, 90, 90}, {90, 90, 90}, {90, -90, 90}}};
  const Scene scene(patches + std::vector<Points>{{{0, 0, 20}, {1, 0, 20}, {0, 1, 21}},
                                                  {{9, 0, 20}, {10, 0, 20}, {9, 1, 21}},
                                                  {{-3, 0, 2}, {-4, 0, 2}, {-3, 1, 3}}});
  StretchHull3 hull(scene.bodies());
  const Stretch3 edge = scene.stretch({0, 0, 10}, {1, 0, 10});
  hull.take(edge, 0, 1, 1);
  for (const std::uint32_t body : {2u, 3u}) EXPECT_FALSE(hull.hides_nothing(body)) << body;
  hull.take_lines_from(0);
  EXPECT_FALSE(hull.hides_nothing(2));
  EXPECT_TRUE(hull.hides_nothing(3));
}

// A stretch just over the middle of a patch: from there lines go everywhere, however far the corners are.
TEST(StretchHull3, LinesFromANearPatchGoEverywhere) {
  const std::vector<Points> patches{{{-50, -50, 0}, {50, -50, 0}, {50, 50, 0}, {-50, 50, 0}},
                                    {{-90, -90, 90}, {-90, 90, 90}, {90, 90, 90}, {90, -90, 90}}};
  const Scene scene(patches +
                    std::vector<Points>{{{0, 0, 20}, {1, 0, 20}, {0, 1, 21}}, {{15, 0, 20}, {16, 0, 20}, {15, 1, 21}}});
  for (const int k : {1, 30, 45, 60, 200}) {
    const Rational z = scaled_by_power_of_two(Rational(1), -k);
    StretchHull3 hull(scene.bodies());
    const Stretch3 edge = scene.stretch({0, 0, z}, {1, 0, z});
    hull.take(edge, 0, 1, 1);
    hull.take_lines_from(0);
    EXPECT_FALSE(hull.hides_nothing(2)) << k;
    EXPECT_FALSE(hull.hides_nothing(3)) << k;
  }
}

}  // namespace
}  // namespace hottel::solid_cover_test

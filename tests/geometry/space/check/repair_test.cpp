#include "geometry/space/check/repair.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/space/check/shells.h"
#include "geometry/space/contacts/near_contacts.h"
#include "geometry/space/scene/polygon_places.h"
#include "tests/geometry/space/check/small_scene.h"

namespace hottel::repair_test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::StartsWith;
using testing_space::add;
using testing_space::add_box;
using testing_space::empty_scene;
using testing_space::q;
using testing_space::told;
using testing_space::unit_room;

const Rational kGap = Rational(1) / 1000000;

std::vector<std::string> steps(const Repair3& repair) {
  std::vector<std::string> result;
  for (const RepairStep& step : repair.steps) result.push_back(step.kind + " " + step.surface);
  return result;
}

TEST(Repair3, WithoutAGapTheSceneStaysAsItIs) {
  Scene3 scene = unit_room();
  add_box(scene, "box", {q("1/4"), q("1/4"), 0}, {q("3/4"), q("3/4"), q("1/2")}, false);
  const Repair3 repair = close_gaps(scene, kGap);
  EXPECT_THAT(repair.steps, IsEmpty());
  EXPECT_EQ(repair.scene.polygons, scene.polygons);
  EXPECT_EQ(repair.scene.surfaces, scene.surfaces);
}

TEST(Repair3, CornersGoToTheOneListedFirst) {
  Scene3 scene = empty_scene();
  add(scene, "a", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  add(scene, "b", {{-kGap, kGap, 0}, {0, 1, 1}, {-1, 0, 1}});
  const Repair3 repair = close_gaps(scene, 2 * kGap);
  EXPECT_THAT(steps(repair), ElementsAre("merged b"));
  EXPECT_EQ(repair.scene.polygons[1].points[0], (Point3{0, 0, 0}));
  EXPECT_EQ(repair.scene.polygons[0], scene.polygons[0]);
  EXPECT_THAT(close_gaps(scene, kGap / 2).steps, IsEmpty()) << "it is farther away than that";
}

TEST(Repair3, CornersGoOntoEdgesAndFacesExactly) {
  for (const bool is_edge : {false, true}) {
    Scene3 scene = empty_scene();
    add(scene, "plate", {{0, 0, 0}, {3, 1, 0}, {2, 3, 1}});
    const Point3& a = scene.polygons[0].points[0];
    const Vector3 u = scene.polygons[0].points[1] - a, v = scene.polygons[0].points[2] - a;
    Point3 tip = moved(a, q("0.37"), u);
    if (!is_edge) tip = moved(tip, q("0.21"), v);
    tip.z += kGap;
    add(scene, "tip", {tip, {0, 0, 5}, {0, 5, 5}});
    const Repair3 repair = close_gaps(scene, 2 * kGap);
    EXPECT_THAT(steps(repair), ElementsAre("snapped tip"));
    const Point3& now = repair.scene.polygons[1].points[0];
    EXPECT_TRUE(contains(scene.polygons[0], now));
    if (is_edge) {
      EXPECT_EQ(closest_point(Side3{a, moved(a, 1, u)}, now).squared, 0);
    }
    EXPECT_LE(squared_distance(now, tip), 4 * kGap * kGap);
    EXPECT_THAT(find_contacts(repair.scene).near, IsEmpty());
  }
}

// The length of the longest coordinate of the scene, once decimals are checked to be decimals.
std::size_t longest_decimal(const Scene3& scene) {
  std::size_t longest = 0;
  for (const Polygon3& polygon : scene.polygons)
    for (const Point3& p : polygon.points)
      for (const Rational* c : {&p.x, &p.y, &p.z}) {
        Integer power;
        mpz_ui_pow_ui(power.get_mpz_t(), 10, 200);
        EXPECT_EQ(power % c->get_den(), 0) << to_string(*c);
        longest = std::max(longest, to_string(*c).size());
      }
  return longest;
}

// A chain of triangles typed to six digits: each has a corner near the face of the one before, which moves.
TEST(Repair3, CornersThatGoOntoWhatMovedHaveDecimalsThatDoNotMultiply) {
  Scene3 scene = empty_scene();
  const Vector3 to_face{q("0.271828"), q("0.314159"), q("0.161803")};
  Point3 corner{0, 0, 0};
  for (int k = 0; k < 6; ++k) {
    const Vector3 u{q("1.234567"), q("0.345678") + k, q("-0.765432")},
        v{q("0.192837") - k, q("1.564738"), q("0.987654")};
    add(scene, "t" + std::to_string(k), {corner, moved(corner, 1, u), moved(corner, 1, v)});
    corner = moved(moved(moved(corner, q("0.37"), u), q("0.29"), v), kGap, to_face);
  }
  const Repair3 repair = close_gaps(scene, 4 * kGap);
  EXPECT_THAT(repair.steps, SizeIs(5));
  EXPECT_THAT(find_contacts(repair.scene).near, IsEmpty());
  EXPECT_LE(longest_decimal(repair.scene), 120);
}

TEST(Repair3, WhatLiesOnSomethingStaysOnIt) {
  Scene3 scene = unit_room();
  const Rational x = 1 - kGap;
  add(scene, "partition", {{q("1/2"), q("1/2"), 0}, {x, q("1/2"), 0}, {x, q("1/2"), 1}, {q("1/2"), q("1/2"), 1}});
  const Repair3 repair = close_gaps(scene, 2 * kGap);
  EXPECT_THAT(steps(repair), ElementsAre("snapped partition", "snapped partition"));
  EXPECT_THAT(repair.scene.polygons.back().points, ElementsAre(Point3{q("1/2"), q("1/2"), 0}, Point3{1, q("1/2"), 0},
                                                               Point3{1, q("1/2"), 1}, Point3{q("1/2"), q("1/2"), 1}));
}

TEST(Repair3, ABoxThatFloatsByALittleIsPutOnTheFloor) {
  Scene3 scene = unit_room();
  add_box(scene, "box", {q("1/4"), q("1/4"), kGap}, {q("3/4"), q("3/4"), q("1/2")}, false);
  const Repair3 repair = close_gaps(scene, 2 * kGap);
  EXPECT_EQ(repair.steps.size(), 4u);
  Scene3 expected = unit_room();
  add_box(expected, "box", {q("1/4"), q("1/4"), 0}, {q("3/4"), q("3/4"), q("1/2")}, false);
  EXPECT_EQ(repair.scene.polygons, expected.polygons);
}

TEST(Repair3, APolygonThatWouldNotBePlaneBecomesTriangles) {
  Scene3 scene = empty_scene();
  add(scene, "peak", {{0, 0, kGap}, {-1, 0, 1}, {0, -1, 1}});
  add(scene, "plate", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  const Repair3 repair = close_gaps(scene, 2 * kGap);
  EXPECT_THAT(steps(repair), ElementsAre("merged plate", "triangulated plate"));
  ASSERT_EQ(repair.scene.surfaces.size(), 3u);
  EXPECT_EQ(repair.scene.surfaces[1].name, "plate[0]");
  EXPECT_EQ(repair.scene.surfaces[2].name, "plate[1]");
  validate(repair.scene);
}

TEST(Repair3, WhatWouldBeNoPolygonKeepsItsCorners) {
  // It would have to be bent, and no fan of triangles fits into it.
  Scene3 scene = empty_scene();
  add(scene, "peak", {{3, 0, kGap}, {4, 0, 1}, {4, 1, 1}});
  add(scene, "yoke", {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {2, 3, 0}, {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}});
  const Repair3 repair = close_gaps(scene, 2 * kGap);
  validate(repair.scene);
  EXPECT_EQ(repair.scene.polygons[1], scene.polygons[1]);
  EXPECT_THAT(steps(repair), ElementsAre("merged peak", "not-repaired yoke"));
}

TEST(Repair3, WhatHasNoAreaLeftIsDropped) {
  Scene3 scene = empty_scene();
  add(scene, "plate", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  add(scene, "crumb", {{0, 0, kGap}, {kGap, 0, kGap}, {0, kGap, kGap}});
  const Repair3 repair = close_gaps(scene, 4 * kGap);
  ASSERT_EQ(repair.scene.surfaces.size(), 1u);
  EXPECT_EQ(repair.scene.surfaces[0].name, "plate");
  EXPECT_EQ(repair.steps.back().kind, "dropped");
}

TEST(Repair3, NoCornerMovesFartherThanItMay) {
  // A row of corners, each within reach of the next one.
  Scene3 scene = empty_scene();
  for (int k = 0; k < 6; ++k) add(scene, "t" + std::to_string(k), {{k * kGap, 0, 0}, {k + 1, 1, k}, {k + 1, 2, k + 1}});
  const Repair3 repair = close_gaps(scene, kGap);
  EXPECT_FALSE(repair.steps.empty());
  for (std::size_t s = 0; s < scene.polygons.size(); ++s)
    EXPECT_LE(squared_distance(scene.polygons[s].points[0], repair.scene.polygons[s].points[0]), kGap * kGap);
}

TEST(Repair3, PolygonsUpsideDownAreReversed) {
  Scene3 scene = unit_room();
  const Polygon3 before = scene.polygons[2];
  std::reverse(scene.polygons[2].points.begin() + 1, scene.polygons[2].points.end());
  Repair3 repair = unrepaired(scene);
  reverse_upside_down(repair);
  EXPECT_THAT(steps(repair), ElementsAre("reversed front"));
  EXPECT_EQ(repair.scene.polygons[2], before);
}

// A box inside out beside another one, face to face: what is one polygon twice is so only because of that.
TEST(Repair3, NoFaceOfAClosedPartIsDropped) {
  Scene3 scene = empty_scene();
  scene.sky_emission = Spectrum::scalar(1);
  add_box(scene, "turned", {0, 0, 0}, {1, 1, 1}, true);
  add_box(scene, "beside", {1, 0, 0}, {2, 1, 1}, false);
  EXPECT_THAT(told(scene,
                   [&] {
                     Findings3 findings;
                     tell_inside_out(scene, inside_out_shells(scene), findings);
                     return findings;
                   }()),
              Contains(StartsWith("warning inside-out")));
  Repair3 repair = unrepaired(scene);
  drop_doubles(repair);
  EXPECT_THAT(repair.steps, IsEmpty());
  reverse_inside_out(repair);
  EXPECT_EQ(steps(repair).size(), 1u);
  EXPECT_THAT(closed_parts(repair.scene), SizeIs(2));
  EXPECT_THAT(inside_out_shells(repair.scene), IsEmpty());
}

TEST(Repair3, OfASheetAndTheFaceOfABoxThatIsTheSameTheSheetIsDropped) {
  for (const bool is_sheet_first : {true, false}) {
    Scene3 scene = empty_scene();
    const auto add_sheet = [&] { add(scene, "sheet", {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}); };
    if (is_sheet_first) add_sheet();
    add_box(scene, "box", {0, 0, 0}, {1, 1, 1}, false);
    if (!is_sheet_first) add_sheet();
    for (Surface& surface : scene.surfaces) surface.material = 0;
    Repair3 repair = unrepaired(scene);
    drop_doubles(repair);
    EXPECT_THAT(steps(repair), ElementsAre("dropped sheet"));
    EXPECT_THAT(closed_parts(repair.scene), SizeIs(1));
  }
}

// While there are two of it, both move, or none where more would be found of two: the second repair would move one.
TEST(Repair3, OfASheetTypedTwiceNearAWallOneIsLeftBeforeAnythingMoves) {
  Scene3 scene = empty_scene();
  const auto at = [](const char* x, const char* y, const char* z) { return Point3{q(x), q(y), q(z)}; };
  const std::vector<Point3> sheet{at("1.377402", "0.460744", "1.262133"), at("1.364852", "0.652268", "1.205912"),
                                  at("0.659724", "0.538851", "0.976936"), at("0.672273", "0.347326", "1.033157")};
  add(scene, "wall",
      {at("4.700858", "0.756116", "1.526505"), at("0", "0", "0"), at("-0.736721", "0.539283", "2.001604"),
       at("3.796701", "1.417963", "3.983019")});
  add(scene, "sheet", sheet);
  add(scene, "again", {sheet[2], sheet[3], sheet[0], sheet[1]});
  for (Surface& surface : scene.surfaces) surface.material = 0, surface.back = 0;
  const Repair3 repair = close_gaps(scene, 1000 * kGap);
  EXPECT_THAT(steps(repair), Contains("dropped again"));
  EXPECT_THAT(steps(repair), Contains("snapped sheet"));
  for (const RepairStep& step : close_gaps(repair.scene, 1000 * kGap).steps) EXPECT_EQ(step.kind, "not-repaired");
  for (std::size_t s = 0; s < repair.origins.size(); ++s)
    EXPECT_THAT(repair.former_names[s], StartsWith(scene.surfaces[repair.origins[s]].name));
}

}  // namespace
}  // namespace hottel::repair_test

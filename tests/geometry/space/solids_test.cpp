// Closed meshes, what they are, and what is within them, on the smallest scenes.
#include "geometry/space/arrangement/solids.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/geometry/space/box_scene.h"
#include "tests/refusal.h"

namespace hottel::solids_test {
namespace {

using ::testing::HasSubstr;
using Kind = ClosedMesh3::Kind;

const Rational kHalf = Rational(1) / 2;

// The kind of the one mesh there is; nothing where there is none, or several.
std::optional<Kind> kind_of(const Scene3& scene) {
  const Solids3 solids(scene);
  return solids.meshes().size() == 1 ? std::optional(solids.meshes()[0].kind) : std::nullopt;
}

// Whether each side of a polygon looks into a solid, at a point of it.
struct Sides {
  bool front, back;
  friend bool operator==(const Sides&, const Sides&) = default;
};
Sides sides(const Scene3& scene, std::uint32_t surface, const Point3& at) {
  const Solids3 solids(scene);
  const PlaneFrame3 frame(scene.polygons[surface].points);
  const bool is_up = frame.is_front_up(scene.polygons[surface].points);
  return {solids.behind({&frame, frame.flat(at), is_up}).has_value(),
          solids.behind({&frame, frame.flat(at), !is_up}).has_value()};
}

TEST(Solids3, AMeshWithFrontsOutwardIsSolid) {
  BoxScene3 scene;
  scene.box("box", {0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(kind_of(scene), Kind::kSolid);
  const Solids3 solids(scene);
  EXPECT_FALSE(solids.is_empty());
  EXPECT_EQ(solids.around({kHalf, kHalf, kHalf}), 0u);
  EXPECT_EQ(solids.around({kHalf, kHalf, 2}), std::nullopt);
  EXPECT_EQ(sides(scene, kTop, {kHalf, kHalf, 1}), (Sides{false, true}));
}

TEST(Solids3, AMeshWithFrontsInwardIsARoomAndMakesNothingSolid) {
  BoxScene3 scene;
  scene.box("room", {0, 0, 0}, {1, 1, 1}, true);
  EXPECT_EQ(kind_of(scene), Kind::kRoom);
  const Solids3 solids(scene);
  EXPECT_TRUE(solids.is_empty());
  EXPECT_EQ(solids.around({kHalf, kHalf, kHalf}), std::nullopt);
  EXPECT_EQ(sides(scene, kTop, {kHalf, kHalf, 1}), (Sides{false, false}));
}

TEST(Solids3, AMeshThatOverlapsItselfIsTangledAndMakesNothingSolid) {
  BoxScene3 overlapping, mixed, doubled;
  overlapping.box("a", {0, 0, 0}, {2, 2, 2});
  overlapping.box_of_group("b", {1, 1, 1}, {3, 3, 3});
  mixed.box("a", {0, 0, 0}, {1, 1, 1});
  mixed.box_of_group("b", {2, 0, 0}, {3, 1, 1}, true);
  doubled.box("a", {0, 0, 0}, {1, 1, 1});
  doubled.box_of_group("b", {0, 0, 0}, {1, 1, 1});
  for (const BoxScene3* scene : {&overlapping, &mixed, &doubled}) {
    EXPECT_EQ(kind_of(*scene), Kind::kTangled);
    EXPECT_TRUE(Solids3(*scene).is_empty());
    EXPECT_EQ(Solids3(*scene).around({kHalf, kHalf, kHalf}), std::nullopt);
  }
}

TEST(Solids3, OneMeshMayBeSeveralSolidsThatTouch) {
  BoxScene3 apart, side, edge, hollow;
  apart.box("a", {0, 0, 0}, {1, 1, 1});
  apart.box_of_group("b", {2, 0, 0}, {3, 1, 1});
  edge.box("a", {0, 0, 0}, {1, 1, 1});
  edge.box_of_group("b", {1, 1, 0}, {2, 2, 1});
  hollow.box("a", {0, 0, 0}, {3, 3, 3});
  hollow.box_of_group("b", {1, 1, 1}, {2, 2, 2}, true);
  for (const BoxScene3* scene : {&apart, &edge, &hollow}) {
    EXPECT_EQ(kind_of(*scene), Kind::kSolid);
    EXPECT_EQ(Solids3(*scene).around({kHalf, kHalf, kHalf}), 0u);
  }
  EXPECT_EQ(Solids3(hollow).around({1 + kHalf, 1 + kHalf, 1 + kHalf}), std::nullopt);
  // Two side by side, and what goes there and back.
  side.box("a", {0, 0, 0}, {1, 1, 1});
  side.box_of_group("b", {1, 0, 0}, {2, 1, 1});
  EXPECT_EQ(kind_of(side), Kind::kSolid);
  EXPECT_EQ(sides(side, kEast, {1, kHalf, kHalf}), (Sides{true, true}));
}

TEST(Solids3, OutlinesCancelWhereEdgesAreDividedAnyhow) {
  BoxScene3 scene;
  const std::uint32_t bottom = scene.box("box", {0, 0, 0}, {2, 2, 2});
  // The top in two parts, one of which has a corner in the middle of a side.
  scene.polygons[bottom + kTop] = level(0, 0, 1, 2, 2);
  scene.member("other half", {{{1, 0, 2}, {2, 0, 2}, {2, 1, 2}, {2, 2, 2}, {1, 2, 2}}});
  EXPECT_EQ(kind_of(scene), Kind::kSolid);
  scene.polygons.back() = level(1, 0, 2, 1, 2);
  EXPECT_EQ(kind_of(scene), std::nullopt);  // a quarter of the top is not there
}

TEST(Solids3, HolesAreOutlinesToo) {
  // A box with a shaft from top to bottom.
  BoxScene3 scene;
  const std::uint32_t bottom = scene.box("ring", {0, 0, 0}, {3, 3, 1});
  for (const std::uint32_t s : {bottom + kBottom, bottom + kTop})
    scene.polygons[s].holes.push_back(level(1, 1, 2, 2, s == bottom + kTop ? 1 : 0).points);
  EXPECT_EQ(kind_of(scene), std::nullopt);  // the shaft has no walls
  BoxScene3 shaft;
  shaft.box("shaft", {1, 1, 0}, {2, 2, 1}, true);
  for (const std::uint32_t side : {kSouth, kNorth, kWest, kEast})
    scene.member("shaft " + std::to_string(side), shaft.polygons[side]);
  EXPECT_EQ(kind_of(scene), Kind::kSolid);
  std::reverse(scene.polygons[bottom].holes[0].begin(), scene.polygons[bottom].holes[0].end());
  EXPECT_EQ(kind_of(scene), Kind::kSolid);
  EXPECT_EQ(Solids3(scene).around({kHalf, kHalf, kHalf}), 0u);
  EXPECT_EQ(Solids3(scene).around({1 + kHalf, 1 + kHalf, kHalf}), std::nullopt);
}

TEST(Solids3, WhatIsNotClosedHasABackOrIsSaidToBeOpenIsNoMesh) {
  BoxScene3 scene;
  scene.box("box", {0, 0, 0}, {1, 1, 1});
  scene.surfaces[kTop].back = 0;
  EXPECT_TRUE(Solids3(scene).meshes().empty());
  scene.surfaces[kTop].back.reset();
  EXPECT_EQ(kind_of(scene), Kind::kSolid);
  scene.groups[0].behind = Behind::kOpen;
  EXPECT_TRUE(Solids3(scene).meshes().empty());
  scene.groups[0].behind = Behind::kSolid;
  EXPECT_EQ(kind_of(scene), Kind::kSolid);
  scene.groups[0].behind = Behind::kByOutline;
  scene.polygons[kTop] = turned(scene.polygons[kTop]);  // its sides no longer cancel
  EXPECT_TRUE(Solids3(scene).meshes().empty());
  scene.polygons.pop_back();
  scene.surfaces.pop_back();
  EXPECT_TRUE(Solids3(scene).meshes().empty());
  EXPECT_EQ(Solids3(scene).mesh_of(0), nullptr);
}

TEST(Solids3, AGroupThatIsSaidToBeSolidMustBe) {
  const auto refusal = [](const BoxScene3& scene) { return refusal_by([&] { Solids3{scene}; }); };
  BoxScene3 open, room, with_back;
  for (BoxScene3* scene : {&open, &room, &with_back}) {
    scene->box("box", {0, 0, 0}, {1, 1, 1}, scene == &room);
    scene->groups[0].behind = Behind::kSolid;
  }
  EXPECT_EQ(refusal(open), "");
  open.polygons.pop_back();
  open.surfaces.pop_back();
  with_back.surfaces[kTop].back = 0;
  for (const BoxScene3* scene : {&open, &room, &with_back}) EXPECT_THAT(refusal(*scene), HasSubstr("'box'"));
}

TEST(Solids3, GroupsOfABodyAreAskedTogetherWhereNoneClosesAlone_2) {
  BoxScene3 scene;
  scene.box("a", {0, 0, 0}, {1, 1, 1});
  scene.groups.emplace_back("lid");
  scene.surfaces[kTop].group = 1;
  EXPECT_TRUE(Solids3(scene).meshes().empty());
  for (Group& group : scene.groups) group.body = "whole";
  const Solids3 solids(scene);
  ASSERT_EQ(solids.meshes().size(), 1u);
  EXPECT_EQ(solids.meshes()[0].name, "whole");
  EXPECT_EQ(solids.meshes()[0].kind, Kind::kSolid);
  EXPECT_EQ(solids.mesh_of(0), &solids.meshes()[0]);
  EXPECT_EQ(solids.mesh_of(1), &solids.meshes()[0]);
  EXPECT_EQ(solids.around({kHalf, kHalf, kHalf}), 0u);
  // A third one that closes alone: the two are asked alone, and do not.
  scene.box("b", {2, 0, 0}, {3, 1, 1});
  scene.groups.back().body = "whole";
  ASSERT_EQ(Solids3(scene).meshes().size(), 1u);
  EXPECT_EQ(Solids3(scene).meshes()[0].name, "b");
  EXPECT_EQ(Solids3(scene).around({kHalf, kHalf, kHalf}), std::nullopt);
  scene.groups[1].behind = Behind::kSolid;
  EXPECT_THAT(refusal_by([&] { Solids3{scene}; }), HasSubstr("'lid' cannot be solid"));
}

TEST(Solids3, TheMeshOfAGroupIsFoundByItsNumber) {
  BoxScene3 scene;
  scene.polygon("sheet", level(5, 5, 6, 6, 0));
  scene.box("a", {0, 0, 0}, {1, 1, 1});
  scene.polygon("other", level(5, 5, 6, 6, 1));
  scene.box("b", {2, 0, 0}, {3, 1, 1}, true);
  const Solids3 solids(scene);
  ASSERT_EQ(solids.meshes().size(), 2u);
  EXPECT_EQ(solids.mesh_of(0), nullptr);
  EXPECT_EQ(solids.mesh_of(1), &solids.meshes()[0]);
  EXPECT_EQ(solids.mesh_of(2), nullptr);
  EXPECT_EQ(solids.mesh_of(3), &solids.meshes()[1]);
  EXPECT_EQ(solids.meshes()[1].kind, Kind::kRoom);
}

TEST(Solids3, ARoomWithinASolidIsFree) {
  BoxScene3 scene;
  scene.box("building", {0, 0, 0}, {4, 4, 4});
  scene.box("room", {1, 1, 1}, {3, 3, 4}, true);  // it touches the top from within
  const Solids3 solids(scene);
  EXPECT_EQ(solids.around({2, 2, 2}), std::nullopt);
  EXPECT_EQ(solids.around({kHalf, 2, 2}), 0u);
  EXPECT_EQ(solids.around({2, 2, 1}), std::nullopt);  // on the floor of the room
  EXPECT_EQ(sides(scene, *scene.find("room bottom"), {2, 2, 1}), (Sides{false, true}));
  EXPECT_EQ(sides(scene, *scene.find("building top"), {2, 2, 4}), (Sides{false, false}));
  EXPECT_EQ(sides(scene, *scene.find("building top"), {kHalf, 2, 4}), (Sides{false, true}));
}

TEST(Solids3, ARoomThatLeavesTheSolidIsNoneOfIts) {
  BoxScene3 scene;
  scene.box("building", {0, 0, 0}, {4, 4, 4});
  scene.box("room", {1, 1, 1}, {3, 3, 5}, true);
  EXPECT_EQ(Solids3(scene).around({2, 2, 2}), 0u);
}

TEST(Solids3, ARoomAcrossTheNotchOfASolidIsNoneOfIts) {
  // A U: all corners of the room are in its arms, but the room is not.
  BoxScene3 scene;
  scene.groups.emplace_back("U");
  const std::vector<std::array<int, 2>> outline{{0, 0}, {6, 0}, {6, 3}, {4, 3}, {4, 1}, {2, 1}, {2, 3}, {0, 3}};
  Polygon3 top, bottom;
  for (const auto& [x, y] : outline) {
    top.points.push_back({x, y, 2});
    bottom.points.insert(bottom.points.begin(), {x, y, 0});
  }
  scene.member("top", top);
  scene.member("bottom", bottom);
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const auto [a, b] = outline[k];
    const auto [c, d] = outline[(k + 1) % outline.size()];
    scene.member("side " + std::to_string(k), {{{a, b, 0}, {c, d, 0}, {c, d, 2}, {a, b, 2}}});
  }
  EXPECT_EQ(kind_of(scene), Kind::kSolid);
  scene.box("room", {1, 2, 0}, {5, 3, 2}, true);
  EXPECT_EQ(Solids3(scene).around({1 + kHalf, 2 + kHalf, 1}), 0u);
  EXPECT_EQ(Solids3(scene).around({3, 2 + kHalf, 1}), std::nullopt);
}

TEST(Solids3, PointsOfFacesAreInNoSolid) {
  BoxScene3 scene;
  scene.box("box", {0, 0, 0}, {1, 1, 1});
  const Solids3 solids(scene);
  for (const Point3& p : {Point3{0, 0, 0}, Point3{kHalf, 0, 0}, Point3{kHalf, kHalf, 1}})
    EXPECT_EQ(solids.around(p), std::nullopt);
}

TEST(Solids3, TheFirstListedSolidIsTold) {
  BoxScene3 scene;
  scene.box("a", {0, 0, 0}, {2, 2, 2});
  scene.box("b", {0, 0, 0}, {2, 2, 3});
  EXPECT_EQ(Solids3(scene).around({1, 1, 1}), 0u);
  EXPECT_EQ(Solids3(scene).around({1, 1, 2}), 1u);  // on a face of a, within b
}

TEST(Solids3, RaysThatMeetEdgesAndCornersAreTakenAnew) {
  // Above the point, below it and beside it are corners and edges of a pyramid, and the borders between triangles.
  BoxScene3 scene;
  scene.groups.emplace_back("octahedron");
  const std::array<Point3, 6> p{Point3{1, 0, 0},  Point3{0, 1, 0}, Point3{-1, 0, 0},
                                Point3{0, -1, 0}, Point3{0, 0, 1}, Point3{0, 0, -1}};
  for (std::size_t k = 0; k < 4; ++k) {
    scene.member("up " + std::to_string(k), {{p[k], p[(k + 1) % 4], p[4]}});
    scene.member("down " + std::to_string(k), {{p[(k + 1) % 4], p[k], p[5]}});
  }
  EXPECT_EQ(kind_of(scene), Kind::kSolid);
  const std::uint32_t sheet = scene.polygon("sheet", level(-2, -2, 2, 2, 0), 0, 0);
  EXPECT_EQ(Solids3(scene).around({0, 0, 0}), 0u);
  EXPECT_EQ(sides(scene, sheet, {0, 0, 0}), (Sides{true, true}));
  EXPECT_EQ(sides(scene, sheet, {Rational(3) / 2, 0, 0}), (Sides{false, false}));
}

TEST(Solids3, AnInnerPointIsTouchedByNoFaceOfAnotherPlane) {
  // The tip of a tetrahedron touches the floor exactly where the mean of its corners is.
  BoxScene3 scene;
  scene.groups.emplace_back("tip");
  const Point3 tip{1, 1, 0}, a{0, 0, 2}, b{2, 0, 2}, c{1, 2, 2};
  scene.member("roof", {{a, b, c}});
  scene.member("1", {{tip, b, a}});
  scene.member("2", {{tip, c, b}});
  scene.member("3", {{tip, a, c}});
  EXPECT_EQ(kind_of(scene), Kind::kSolid);
  const std::vector<Point3> floor = level(0, 0, 2, 2, 0).points;
  const PlaneFrame3 frame(floor);
  std::vector<FlatPoint3> flat;
  for (const Point3& p : floor) flat.push_back(frame.flat(p));
  const FlatPoint3 inner = Solids3(scene).inner_point(frame, flat);
  EXPECT_FALSE(frame.point(inner) == tip);
  EXPECT_TRUE(contains({floor, {}}, frame.point(inner)));
}

TEST(Solids3, CutsAreWhereFacesOfOtherPlanesEnterThePolygon) {
  BoxScene3 scene;
  scene.box("box", {1, 1, -1}, {2, 2, 1});
  const Solids3 solids(scene);
  const auto cuts_at = [&](const Polygon3& polygon) {
    const PlaneFrame3 frame(polygon.points);
    std::vector<FlatPoint3> flat;
    ClosedMesh3::Box box;
    for (const Point3& p : polygon.points) {
      flat.push_back(frame.flat(p));
      box.include(p);
    }
    std::vector<FlatSegment3> cuts;
    solids.append_cuts(frame, flat, box, cuts);
    return cuts.size();
  };
  EXPECT_EQ(cuts_at(level(0, 0, 4, 4, 0)), 4u);
  EXPECT_EQ(cuts_at(level(0, 0, 4, 4, 1)), 4u);  // it lies on the top: the sides end there
  EXPECT_EQ(cuts_at(level(0, 0, 4, 4, 2)), 0u);  // above
  EXPECT_EQ(cuts_at(level(0, 0, 1, 4, 0)), 0u);  // beside: only its border is met
  EXPECT_EQ(cuts_at(level(0, 0, kHalf + 1, 4, 0)), 3u);
  EXPECT_EQ(cuts_at(level(kHalf + 1, kHalf + 1, Rational(7) / 4, Rational(7) / 4, 0)), 0u);  // all within
}

}  // namespace
}  // namespace hottel::solids_test

#include "viewer/edit/plane/scene_edits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "kernel/support/failure.h"
#include "tests/viewer/edit/plane/edited_scenes.h"

namespace hottel::scene_edits_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

using Surfaces = std::vector<std::uint32_t>;
constexpr std::uint32_t kScreen = 0, kRoom = 1, kStep = 5, kTable = 7;
const Surfaces kWholeTable{7, 8, 9, 10};

std::string group_of(const Scene2& scene, std::uint32_t s) { return scene.groups[scene.surfaces[s].group].name; }

std::vector<std::string> group_names(const Scene2& scene) {
  std::vector<std::string> result;
  for (const Group& group : scene.groups) result.push_back(group.name);
  return result;
}

void expect_saved(const Scene2& scene) { EXPECT_EQ(difference(saved_and_read(scene), scene), ""); }

TEST(MovePoints2, MovesAllThatMeetsThereAtOnce) {
  const Scene2 scene = small_room();
  // The corner goes where another one was, and that one goes on.
  const std::vector<PointMove2> moves{{{4, 3}, {4, 0}}, {{4, 0}, {5, 0}}, {{4, 3}, {9, 9}}};
  const Scene2 edited = move_points(scene, moves);
  EXPECT_EQ(edited.edges[kRoom + 1], (Edge2{{0, 3}, {4, 0}}));
  EXPECT_EQ(edited.edges[kRoom + 2], (Edge2{{4, 0}, {5, 0}}));
  EXPECT_EQ(edited.edges[kRoom + 3], (Edge2{{5, 0}, {0, 0}}));
  EXPECT_EQ(edited.edges[kTable], scene.edges[kTable]);
  EXPECT_EQ(group_names(edited), group_names(scene));
  expect_saved(edited);
}

TEST(MovePoints2, TellsPointsApartExactly) {
  const Rational tiny = Rational(1) / Rational("1" + std::string(40, '0'));
  const std::vector<PointMove2> moves{{{4, 3 + tiny}, {5, 5}}};
  EXPECT_EQ(difference(move_points(small_room(), moves), small_room()), "");
}

TEST(MovePoints2, DoesNotThrowForAnInvalidScene) {
  const std::vector<PointMove2> moves{{{4, 3}, {4, 0}}};
  const Scene2 edited = move_points(small_room(), moves);
  EXPECT_EQ(edited.edges[kRoom + 2].from, edited.edges[kRoom + 2].to);
  EXPECT_THROW(validate(edited), InputError);
  EXPECT_EQ(group_of(edited, kRoom + 2), "room");
}

TEST(MoveEnd2, PartsAPolylineIntoEdges) {
  const Scene2 edited = move_end(small_room(), kRoom + 1, true, {Rational("7/2"), 3});
  EXPECT_THAT(group_names(edited), ElementsAre("screen", "room[0]", "room[1]", "room[2]", "room[3]", "step", "table"));
  EXPECT_EQ(edited.edges[2], (Edge2{{0, 3}, {Rational("7/2"), 3}}));
  expect_saved(edited);
}

TEST(MoveEnd2, LeavesAPolylineWholeAtItsLooseEnd) {
  const Scene2 edited = move_end(small_room(), kStep, false, {5, 1});
  EXPECT_EQ(group_names(edited), group_names(small_room()));
  EXPECT_EQ(edited.edges[kStep].from, (Point2{5, 1}));
  EXPECT_EQ(edited.edges[kStep].to, small_room().edges[kStep].to);
}

TEST(MoveSurfaces2, MovesThemAloneAndOnce) {
  const Scene2 scene = small_room();
  const Surfaces twice{7, 8, 9, 10, 8};
  const Scene2 edited = move_surfaces(scene, twice, Rational("1/2"), -1);
  for (std::uint32_t s = 0; s < scene.edges.size(); ++s) {
    const Rational dx = s < kTable ? Rational(0) : Rational("1/2"), dy = s < kTable ? 0 : -1;
    EXPECT_EQ(edited.edges[s].from, (Point2{scene.edges[s].from.x + dx, scene.edges[s].from.y + dy}));
    EXPECT_EQ(edited.edges[s].to, (Point2{scene.edges[s].to.x + dx, scene.edges[s].to.y + dy}));
  }
  EXPECT_EQ(group_of(edited, kTable), "table");
  expect_saved(edited);
  const Surfaces piece{kTable + 1};
  EXPECT_THAT(group_names(move_surfaces(scene, piece, 1, 0)),
              ElementsAre("screen", "table[0]", "table[1]", "table[2]", "table[3]", "room", "step"));
}

TEST(RotateSurfaces2, TurnsByQuartersExactly) {
  const Scene2 scene = small_room();
  const Point2 centre{Rational("1/3"), Rational("22/7")};
  for (const int degrees : {90, -270, 90 + 360 * 1000}) {
    const Scene2 edited = rotate_surfaces(scene, kWholeTable, centre, degrees, 0);
    for (const std::uint32_t s : kWholeTable) {
      const Point2& p = scene.edges[s].from;
      EXPECT_EQ(edited.edges[s].from, (Point2{centre.x - (p.y - centre.y), centre.y + (p.x - centre.x)}));
    }
  }
  EXPECT_EQ(difference(rotate_surfaces(scene, kWholeTable, centre, 720, 0), scene), "");
  const Scene2 half = rotate_surfaces(scene, kWholeTable, centre, 180, 0);
  EXPECT_EQ(half.edges[kTable].from, (Point2{2 * centre.x - 2, 2 * centre.y - 1}));
}

TEST(RotateSurfaces2, RoundsOtherTurnsAndKeepsCornersTogether) {
  const Scene2 scene = small_room();
  const Scene2 edited = rotate_surfaces(scene, kWholeTable, {2, 1}, 30, 3);
  EXPECT_EQ(edited.edges[kTable], (Edge2{{2, 1}, {Rational(2866) / 1000, Rational(3) / 2}}));
  EXPECT_EQ(edited.edges[kTable + 1].to, (Point2{Rational(2366) / 1000, Rational(2366) / 1000}));
  EXPECT_EQ(group_of(edited, kTable), "table");
  expect_saved(edited);
  // 120 = 90 + 30, around another place, at hundreds.
  const Scene2 rough = rotate_surfaces(scene, kWholeTable, {1000, 0}, 120, -2);
  EXPECT_EQ(rough.edges[kTable].from, (Point2{1500, -900}));
}

TEST(RotateSurfaces2, TurnsHugeScenesToo) {
  Scene2 scene = small_room();
  const Rational huge("1" + std::string(400, '0'));
  for (const std::uint32_t s : kWholeTable)
    for (Point2* p : {&scene.edges[s].from, &scene.edges[s].to}) *p = {p->x * huge, p->y * huge};
  const Scene2 edited = rotate_surfaces(scene, kWholeTable, {0, 0}, 45, -398);
  EXPECT_EQ(edited.edges[kTable].from, (Point2{huge * 71 / 100, huge * 212 / 100}));
}

TEST(ReverseSurfaces2, KeepsAWholePolylineOne) {
  const Scene2 scene = small_room();
  const Scene2 edited = reverse_surfaces(scene, kWholeTable);
  for (std::uint32_t k = 0; k < 4; ++k) {
    const Edge2& was = scene.edges[kTable + 3 - k];
    EXPECT_EQ(edited.edges[kTable + k], (Edge2{was.to, was.from}));
    EXPECT_EQ(edited.surfaces[kTable + k], scene.surfaces[kTable + k]);
  }
  EXPECT_EQ(group_names(edited), group_names(scene));
  expect_saved(edited);
  EXPECT_EQ(difference(reverse_surfaces(edited, kWholeTable), scene), "");
}

TEST(ReverseSurfaces2, TakesMaterialsAlong) {
  SceneBuilder2 builder;
  builder.add_material("white").add_material("black");
  builder.add_edge("wall", {0, 0}, {1, 0}, "white", {.back = "black", .elements = 3});
  const Scene2 scene = builder.build();
  const Scene2 edited = reverse_surfaces(scene, Surfaces{0});
  EXPECT_EQ(edited.edges[0], (Edge2{{1, 0}, {0, 0}}));
  EXPECT_EQ(edited.surfaces, scene.surfaces);
}

TEST(ReverseSurfaces2, PartsAPolylineOfWhichAPartIsReversed) {
  const Scene2 edited = reverse_surfaces(small_room(), Surfaces{kStep});
  EXPECT_THAT(group_names(edited), ElementsAre("screen", "step[0]", "step[1]", "room", "table"));
  EXPECT_EQ(edited.edges[1], (Edge2{{3, Rational("1/2")}, {4, Rational("1/2")}}));
  expect_saved(edited);
}

TEST(EraseSurfaces2, TakesThemOutAndKeepsMaterials) {
  const Scene2 scene = small_room();
  const Scene2 edited = erase_surfaces(scene, Surfaces{0, 5, 6});
  EXPECT_THAT(group_names(edited), ElementsAre("room", "table"));
  EXPECT_EQ(edited.edges.size(), 8u);
  EXPECT_EQ(edited.materials.size(), scene.materials.size());
  EXPECT_THAT(group_names(erase_surfaces(scene, Surfaces{kStep + 1})), ElementsAre("screen", "room", "step", "table"));
  EXPECT_THAT(group_names(erase_surfaces(scene, Surfaces{kStep})), ElementsAre("screen", "step[1]", "room", "table"));
  EXPECT_THAT(group_names(erase_surfaces(scene, Surfaces{kTable + 2})),
              ElementsAre("screen", "table[0]", "table[1]", "table[3]", "room", "step"));
  const Scene2 empty = erase_surfaces(scene, Surfaces{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
  EXPECT_TRUE(empty.surfaces.empty());
  expect_saved(empty);
}

TEST(DuplicateSurfaces2, CopiesWholePolylinesAsOnes) {
  const Scene2 scene = small_room();
  const auto [edited, added] = duplicate_surfaces(scene, Surfaces{5, 6, 0, 8}, 1, Rational("1/4"));
  EXPECT_THAT(group_names(edited),
              ElementsAre("screen", "screen copy", "table[1] copy", "room", "step", "table", "step copy"));
  EXPECT_THAT(added, ElementsAre(1, 2, 13, 14));
  EXPECT_EQ(edited.surfaces[13].name, "step copy[0]");
  EXPECT_EQ(edited.groups.back().behind, Behind::kSolid);
  EXPECT_EQ(edited.surfaces[14].elements, 2u);
  EXPECT_EQ(edited.edges[13], (Edge2{{5, Rational("3/4")}, {4, Rational("3/4")}}));
  EXPECT_EQ(edited.surfaces[1].back, scene.surfaces[0].back);
  expect_saved(edited);
  EXPECT_EQ(difference(erase_surfaces(edited, added), scene), "");
}

TEST(DuplicateSurfaces2, OfAPieceSaysNothingOfWhatIsBehind) {
  const auto [edited, added] = duplicate_surfaces(small_room(), Surfaces{kStep}, 0, 1);
  EXPECT_EQ(edited.groups[edited.surfaces[added.at(0)].group], Group("step[0] copy"));
}

TEST(DuplicateSurfaces2, CountsCopies) {
  Scene2 scene = small_room();
  for (const char* name : {"screen copy", "screen copy 2", "screen copy 3"}) {
    AddedSurfaces2 next = duplicate_surfaces(scene, Surfaces{scene.surfaces[1].name == "screen copy" ? 1u : 0u}, 1, 0);
    EXPECT_EQ(next.scene.surfaces[next.surfaces.at(0)].name, name);
    scene = std::move(next.scene);
  }
  expect_saved(scene);
}

TEST(AddEdge2, StandsBeforePolylinesAndHasAFreeName) {
  AddedSurfaces2 one = add_edge(small_room(), {{0, 0}, {1, 1}}, 1);
  EXPECT_THAT(one.surfaces, ElementsAre(1));
  EXPECT_EQ(one.scene.surfaces[1].name, "edge 1");
  EXPECT_EQ(one.scene.surfaces[1].material, 1u);
  EXPECT_EQ(one.scene.surfaces[1].back, std::nullopt);
  expect_saved(one.scene);
  const AddedSurfaces2 two = add_edge(one.scene, {{0, 0}, {1, 1}}, 0);
  EXPECT_EQ(two.scene.surfaces[2].name, "edge 2");
  const AddedSurfaces2 again = add_edge(erase_surfaces(two.scene, Surfaces{1}), {{0, 0}, {1, 1}}, 0);
  EXPECT_EQ(again.scene.surfaces[2].name, "edge 1");
}

TEST(AddPolyline2, StandsLast) {
  const std::vector<Point2> points{{5, 0}, {6, 0}, {6, 1}};
  const auto [open, open_surfaces] = add_polyline(small_room(), points, false, 0);
  EXPECT_THAT(open_surfaces, ElementsAre(11, 12));
  EXPECT_EQ(group_of(open, 12), "polyline 1");
  const auto [closed, closed_surfaces] = add_polyline(open, points, true, 0);
  EXPECT_THAT(closed_surfaces, ElementsAre(13, 14, 15));
  EXPECT_EQ(closed.edges[15], (Edge2{{6, 1}, {5, 0}}));
  EXPECT_EQ(closed.surfaces[15].name, "polyline 2[2]");
  expect_saved(closed);
}

TEST(AddLamp2, IsASquareThatEmits) {
  SceneBuilder2 builder;
  builder.add_material("lamp").add_material("lamp 3", {.emission = 5});
  const auto [scene, surfaces] = add_lamp(builder.build(), {1, 2}, Rational("1/2"));
  EXPECT_THAT(surfaces, ElementsAre(0, 1, 2, 3));
  ASSERT_EQ(scene.materials.size(), 3u);
  EXPECT_EQ(scene.materials[2].name, "lamp 2");  // "lamp" does not emit
  EXPECT_EQ(scene.materials[2], (Material{"", Spectrum::scalar(0), Spectrum::scalar(1)}));
  EXPECT_EQ(scene.surfaces[0].material, 2u);
  EXPECT_EQ(scene.edges[0], (Edge2{{Rational("1/2"), Rational("3/2")}, {Rational("3/2"), Rational("3/2")}}));
  EXPECT_EQ(scene.edges[1].to, (Point2{Rational("3/2"), Rational("5/2")}));
  EXPECT_EQ(group_of(scene, 3), "lamp 1");
  expect_saved(scene);
  const Scene2 two = add_lamp(scene, {5, 5}, 1).scene;
  EXPECT_EQ(two.materials.size(), 3u);
  EXPECT_EQ(two.surfaces[4].material, 2u);
  EXPECT_EQ(add_lamp(small_room(), {2, Rational("5/2")}, Rational("1/10")).scene.surfaces[11].material, 1u);
}

TEST(SetMaterial2, ChangesAllThatShareIt) {
  const Scene2 edited = set_material(small_room(), 0, {"other", Spectrum::scalar(1), {{1, 2, 3}, false}});
  EXPECT_EQ(edited.materials[0].name, "white");
  EXPECT_EQ(edited.materials[0].reflectivity, Spectrum::scalar(1));
  EXPECT_EQ(edited.materials[0].emission.value[2], 3);
  EXPECT_EQ(edited.surfaces, small_room().surfaces);
  expect_saved(edited);
}

TEST(CopyMaterial2, IsForTheGroupAndTheSideAlone) {
  const Scene2 scene = small_room();
  const auto front = copy_material(scene, {kTable + 1, false});
  ASSERT_TRUE(front);
  EXPECT_EQ(front->material, 2u);
  EXPECT_EQ(front->scene.materials[2].name, "white copy");
  EXPECT_EQ(front->scene.materials[2], scene.materials[0]);
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s)
    EXPECT_EQ(front->scene.surfaces[s].material, s >= kTable ? 2u : scene.surfaces[s].material);
  EXPECT_EQ(group_of(front->scene, kTable), "table");
  expect_saved(front->scene);
  const auto back = copy_material(front->scene, {kScreen, true});
  ASSERT_TRUE(back);
  EXPECT_EQ(back->scene.materials[3].name, "white copy 2");
  EXPECT_EQ(back->scene.surfaces[kScreen].material, 0u);
  EXPECT_EQ(back->scene.surfaces[kScreen].back, 3u);
  EXPECT_FALSE(copy_material(scene, {kRoom, true}));
}

TEST(CopyMaterial2, LeavesOtherMaterialsOfTheGroup) {
  Scene2 scene = small_room();
  scene.surfaces[kTable].back = 1;
  scene.surfaces[kTable + 1].back = 0;
  scene.surfaces[kTable + 2].back = 0;
  scene.surfaces[kTable + 2].material = 1;
  const auto back = copy_material(scene, {kTable + 2, true});
  ASSERT_TRUE(back);  // its group is four edges now, after the one that was there
  EXPECT_EQ(back->scene.surfaces[1].back, 1u);
  EXPECT_EQ(back->scene.surfaces[2].back, 2u);
  EXPECT_EQ(back->scene.surfaces[3].back, 2u);
  const auto front = copy_material(scene, {kTable, false});
  ASSERT_TRUE(front);
  EXPECT_EQ(front->scene.surfaces[1].material, 2u);
  EXPECT_EQ(front->scene.surfaces[3].material, 1u);
}

TEST(MaterialOfAFace2, IsNothingForABlackBack) {
  const Scene2 scene = small_room();
  EXPECT_EQ(material_of(scene, {kStep, false}), 1u);
  EXPECT_EQ(material_of(scene, {kStep, true}), std::nullopt);
  EXPECT_EQ(material_of(scene, {kScreen, true}), 0u);
}

TEST(SceneEdits2, HaveNoExpectationsAndKeepAllElse) {
  const Scene2 scene = read_scene_2(std::string(HOTTEL_SOURCE_DIR) + "/scenes/analytic/strip_parallel_h1.json");
  ASSERT_THAT(scene.expect, testing::Not(IsEmpty()));
  const Scene2 edited = move_surfaces(scene, Surfaces{0}, 0, 1);
  EXPECT_THAT(edited.expect, IsEmpty());
  EXPECT_EQ(edited.file, scene.file);
  EXPECT_EQ(edited.about, scene.about);
  EXPECT_EQ(edited.surfaces, scene.surfaces);
  EXPECT_FALSE(scene.expect.empty());
}

// What is drawn with it has it on both sides, as reading what is saved will say.
TEST(SceneEdits2, GiveATwoSidedMaterialToTheBack) {
  const Scene2 scene = parse_scene_2(R"({"hottel": 1, "dimension": 2, "materials": {"leaf": {"two_sided": true}},
    "edges": [{"name": "a", "points": [[0, 0], [1, 0]], "material": "leaf"}]})",
                                     "leaf");
  EXPECT_EQ(scene.surfaces[0].back, 0u);
  const AddedSurfaces2 added = add_edge(scene, {{0, 1}, {1, 1}}, 0);
  ASSERT_EQ(added.surfaces.size(), 1u);
  EXPECT_EQ(added.scene.surfaces[added.surfaces[0]].back, 0u);
  const Scene2 read = parse_scene_2(write_scene_2(added.scene), "saved");
  EXPECT_TRUE(read.materials[0].is_two_sided);
  EXPECT_EQ(read.surfaces.size(), 2u);
  for (const Surface& surface : read.surfaces) EXPECT_EQ(surface.back, 0u);
}

TEST(SceneEdits2, RefuseIndicesOutOfRange) {
  const Scene2 scene = small_room();
  const Surfaces out{0, 11};
  const std::vector<Point2> one{{0, 0}}, two{{0, 0}, {1, 0}};
  EXPECT_THROW(move_end(scene, 11, true, {0, 0}), ContractViolation);
  EXPECT_THROW(move_surfaces(scene, out, 1, 0), ContractViolation);
  EXPECT_THROW(rotate_surfaces(scene, out, {0, 0}, 1, 0), ContractViolation);
  EXPECT_THROW(reverse_surfaces(scene, out), ContractViolation);
  EXPECT_THROW(erase_surfaces(scene, out), ContractViolation);
  EXPECT_THROW(duplicate_surfaces(scene, out, 0, 0), ContractViolation);
  EXPECT_THROW(add_edge(scene, {{0, 0}, {1, 0}}, 2), ContractViolation);
  EXPECT_THROW(add_polyline(scene, two, false, 2), ContractViolation);
  EXPECT_THROW(add_polyline(scene, one, true, 0), ContractViolation);
  EXPECT_THROW(add_lamp(scene, {0, 0}, 0), ContractViolation);
  EXPECT_THROW(set_material(scene, 2, {}), ContractViolation);
  EXPECT_THROW(copy_material(scene, {11, false}), ContractViolation);
  EXPECT_THROW(material_of(scene, {11, false}), ContractViolation);
}

}  // namespace
}  // namespace hottel::scene_edits_test

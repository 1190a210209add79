// Patches go with what they lie on.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "kernel/support/failure.h"
#include "tests/viewer/edit/plane/edited_scenes.h"
#include "viewer/edit/plane/pick.h"
#include "viewer/edit/plane/scene_edits.h"

namespace hottel::patch_edits_test {
namespace {

using Surfaces = std::vector<std::uint32_t>;
constexpr std::uint32_t kLabel = 0, kWindow = 1, kPane = 2, kDoor = 3, kRoom = 4, kTable = 8;
const Surfaces kWholeTable{kTable, kTable + 1, kTable + 2, kTable + 3};

void expect_whole(const Scene2& scene) {
  EXPECT_NO_THROW(validate(scene));
  EXPECT_EQ(difference(saved_and_read(scene), scene), "");
}

std::string base_of(const Scene2& scene, const std::string& name) {
  const PatchBase& base = scene.bases.at(*scene.surfaces.at(*scene.find(name)).on);
  return base.name + (base.is_back ? ":back" : "");
}
Edge2 edge_of(const Scene2& scene, const std::string& name) { return scene.edges.at(*scene.find(name)); }

TEST(PatchEdits2, KeepTheirPartOfAWallThatTurns) {
  const std::vector<PointMove2> moves{{{0, 0}, {3, 0}}};
  const Scene2 edited = move_points(patched_room(), moves);
  EXPECT_EQ(edited.edges[kWindow], (Edge2{{2, 1}, {1, 2}}));
  EXPECT_EQ(edited.edges[kPane], (Edge2{{Rational(5, 3), Rational(4, 3)}, {Rational(4, 3), Rational(5, 3)}}));
  // The wall of the door is a quarter as long.
  EXPECT_EQ(edited.edges[kDoor], (Edge2{{Rational(15, 4), 0}, {Rational(7, 2), 0}}));
  expect_whole(edited);
}

TEST(PatchEdits2, MoveWithFurniture) {
  const Scene2 edited = move_surfaces(patched_room(), kWholeTable, Rational(-1, 2), Rational(1, 4));
  EXPECT_EQ(edited.edges[kLabel], (Edge2{{Rational(5, 2), Rational(3, 2)}, {Rational(5, 2), 2}}));
  expect_whole(edited);
  expect_whole(rotate_surfaces(patched_room(), kWholeTable, {2, 1}, 30, 3));
}

TEST(PatchEdits2, SlideAlongWhatTheyLieOn) {
  const Surfaces window{kWindow};
  const Scene2 edited = move_surfaces(patched_room(), window, 1, Rational(1, 2));
  EXPECT_EQ(edited.edges[kWindow], (Edge2{{0, Rational(3, 2)}, {0, Rational(5, 2)}}));
  EXPECT_EQ(edited.edges[kPane], (Edge2{{0, Rational(11, 6)}, {0, Rational(13, 6)}}));
  EXPECT_EQ(move_surfaces(patched_room(), window, 0, 9).edges[kWindow], (Edge2{{0, 2}, {0, 3}})) << "to the end";
  EXPECT_EQ(move_end(patched_room(), kWindow, true, {1, 9}).edges[kWindow], (Edge2{{0, 1}, {0, 3}}));
  expect_whole(edited);
}

TEST(PatchEdits2, AreTurnedRoundErasedAndCopiedWithIt) {
  const Surfaces wall{kRoom}, window{kWindow};
  const Scene2 turned = reverse_surfaces(patched_room(), Surfaces{kRoom, kRoom + 1, kRoom + 2, kRoom + 3});
  EXPECT_EQ(edge_of(turned, "window"), (Edge2{{0, 2}, {0, 1}}));
  EXPECT_EQ(base_of(turned, "door"), "room[0]") << "the wall along the floor is the first one now";
  expect_whole(turned);
  const Scene2 erased = erase_surfaces(patched_room(), wall);
  EXPECT_FALSE(erased.find("window") || erased.find("pane"));
  EXPECT_EQ(base_of(erased, "door"), "room[3]");
  expect_whole(erased);
  Surfaces table = kWholeTable;
  table.push_back(kLabel);
  const Scene2 copied = duplicate_surfaces(patched_room(), table, -1, 0).scene;
  EXPECT_EQ(base_of(copied, "label copy"), "table copy[1]");
  expect_whole(copied);
  const Scene2 two = duplicate_surfaces(patched_room(), window, Rational(1, 8), 1).scene;
  EXPECT_EQ(edge_of(two, "window copy"), (Edge2{{0, 2}, {0, 3}}));
  EXPECT_EQ(base_of(two, "window copy"), "room");
}

TEST(PatchEdits2, NameThePieceOnceAPolylineFallsApart) {
  const Scene2 edited = move_end(patched_room(), kRoom + 1, true, {3, 3});
  EXPECT_EQ(base_of(edited, "window"), "room[0]");
  expect_whole(edited);
}

TEST(PatchEdits2, ArePickedBeforeWhatTheyLieOn) {
  const Scene2 scene = patched_room();
  const ScenePick2 picks(scene);
  EXPECT_EQ(picks.at({0.01, 1.5}, 0.1).surface, kPane);
  EXPECT_EQ(picks.at({0.01, 1.2}, 0.1).surface, kWindow);
  EXPECT_EQ(picks.at({0.01, 0.5}, 0.1).surface, kRoom);
  EXPECT_EQ(picks.at({-0.01, 1.5}, 0.1).surface, kRoom) << "the back is that of the wall";
}

}  // namespace
}  // namespace hottel::patch_edits_test

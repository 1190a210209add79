// Scenes as their files give them back, against the writer and the reader themselves.
#include "viewer/edit/plane/file_order.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/viewer/edit/plane/edited_scenes.h"

namespace hottel::file_order_test {
namespace {

using testing::ElementsAre;

std::vector<std::string> names(const Scene2& scene) {
  std::vector<std::string> result;
  for (const Surface& surface : scene.surfaces) result.push_back(surface.name);
  return result;
}

std::vector<std::string> group_names(const Scene2& scene) {
  std::vector<std::string> result;
  for (const Group& group : scene.groups) result.push_back(group.name);
  return result;
}

Scene2 reordered(const Scene2& scene, const std::vector<std::uint32_t>& order) {
  Scene2 result = scene;
  result.keep(order);
  return result;
}

TEST(AsRead2, IsWhatTheReaderGivesWhateverTheOrder) {
  std::mt19937_64 random(7);
  std::size_t differing = 0;
  for (int round = 0; round < 500; ++round) {
    const Scene2 scene = round % 5 == 0 ? Scene2(read_scene_2(showcase("apartment"))) : small_room();
    std::vector<std::uint32_t> order(scene.surfaces.size());
    for (std::uint32_t s = 0; s < order.size(); ++s) order[s] = s;
    for (std::size_t swaps = random() % 4; swaps > 0; --swaps)
      std::swap(order[random() % order.size()], order[random() % order.size()]);
    if (random() % 3 == 0) std::rotate(order.begin(), order.begin() + random() % order.size(), order.end());
    if (random() % 3 == 0) order.erase(order.begin() + random() % order.size());
    const Scene2 given = reordered(scene, order), read = as_read(given);
    Scene2 expected = saved_and_read(given);
    ASSERT_EQ(difference(read, expected), "") << round;
    ASSERT_EQ(difference(as_read(read), read), "");
    differing += difference(given, read).empty() ? 0 : 1;
    const FileOrder2 ordered = in_file_order(given);
    ASSERT_EQ(difference(as_read(ordered.scene), ordered.scene), "") << round;
    ASSERT_EQ(difference(saved_and_read(ordered.scene), ordered.scene), "") << round;
    for (std::size_t s = 0; s < order.size(); ++s) {
      EXPECT_EQ(ordered.scene.edges[ordered.place[s]], given.edges[s]);
      EXPECT_EQ(ordered.scene.surfaces[ordered.place[s]].name, given.surfaces[s].name);
    }
  }
  EXPECT_GT(differing, 200u);
}

TEST(AsRead2, KeepsTheFileAndWhatWasRead) {
  const Scene2 scene = read_scene_2(showcase("museum"));
  const Scene2 read = as_read(scene);
  EXPECT_EQ(difference(read, scene), "");
  EXPECT_EQ(read.file, scene.file);
  EXPECT_EQ(read.surfaces.back().line, scene.surfaces.back().line);
}

TEST(FileOrder2, PutsEdgesBeforePolylinesAndKeepsBothOrders) {
  const Scene2 given = reordered(small_room(), {5, 6, 1, 2, 3, 4, 0, 7, 8, 9, 10});
  const FileOrder2 ordered = in_file_order(given);
  EXPECT_THAT(group_names(ordered.scene), ElementsAre("screen", "step", "room", "table"));
  EXPECT_THAT(ordered.place, ElementsAre(1, 2, 3, 4, 5, 6, 0, 7, 8, 9, 10));
}

TEST(FileOrder2, LetsAPolylineThatIsNoneFallApartIntoEdgesOfTheSameNames) {
  Scene2 scene = small_room();
  scene.edges[6].to = {2, 0};
  scene.edges[5].from = {4, 1};
  EXPECT_EQ(difference(in_file_order(scene).scene, scene), "");  // it is one still
  scene.edges[5].to = {3, 1};
  const Scene2 ordered = in_file_order(scene).scene;
  EXPECT_THAT(names(ordered), ElementsAre("screen", "step[0]", "step[1]", "room[0]", "room[1]", "room[2]", "room[3]",
                                          "table[0]", "table[1]", "table[2]", "table[3]"));
  EXPECT_THAT(group_names(ordered), ElementsAre("screen", "step[0]", "step[1]", "room", "table"));
  EXPECT_EQ(ordered.groups[1].behind, Behind::kSolid);
  EXPECT_EQ(ordered.groups[2].behind, Behind::kSolid);
}

TEST(FileOrder2, CallsAnEdgeAnewThatHasTheNameOfAPolyline) {
  SceneBuilder2 builder;
  builder.add_material("white");
  builder.add_polyline("a", {{0, 0}, {1, 0}, {1, 1}}, "white").add_polyline("a[0]", {{5, 0}, {6, 0}}, "white");
  Scene2 scene = builder.build();
  scene.edges[0].to = {0, 1};
  const Scene2 ordered = in_file_order(scene).scene;
  EXPECT_THAT(names(ordered), ElementsAre("a[0] 2", "a[1]", "a[0][0]"));
  EXPECT_EQ(difference(saved_and_read(ordered), ordered), "");
}

TEST(FileOrder2, MovesNothingWhereAllIsInOrder) {
  const Scene2 scene = small_room();
  const FileOrder2 ordered = in_file_order(scene);
  EXPECT_EQ(difference(ordered.scene, scene), "");
  for (std::uint32_t s = 0; s < ordered.place.size(); ++s) EXPECT_EQ(ordered.place[s], s);
  EXPECT_TRUE(in_file_order(Scene2{}).scene.surfaces.empty());
}

TEST(FileOrder2, ForgetsGroupsWithoutSurfaces) {
  Scene2 scene = small_room();
  scene.groups.push_back("nothing");
  EXPECT_THAT(group_names(in_file_order(scene).scene), ElementsAre("screen", "room", "step", "table"));
}

}  // namespace
}  // namespace hottel::file_order_test

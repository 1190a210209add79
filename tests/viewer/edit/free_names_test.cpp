#include "viewer/edit/free_names.h"

#include <gtest/gtest.h>

namespace hottel::free_names_test {
namespace {

SceneTable table(const std::vector<std::string>& surfaces, const std::vector<std::string>& groups) {
  SceneTable result;
  for (const std::string& name : surfaces) {
    Surface surface;
    surface.name = name;
    result.surfaces.push_back(surface);
  }
  for (const std::string& name : groups) result.groups.emplace_back(name);
  return result;
}

TEST(FreeNames, AreThoseOfNoSurfaceGroupOrPiece) {
  FreeNames names(table({"edge 1", "room[0]", "edge 3[0]", "a b[1][2]"}, {"edge 1", "edge 4"}));
  EXPECT_EQ(names.numbered("edge"), "edge 2");
  EXPECT_EQ(names.numbered("edge"), "edge 5");
  EXPECT_EQ(names.another("room"), "room 2");
  EXPECT_EQ(names.another("room[0]"), "room[0] 2");
}

TEST(FreeNames, AreGivenOnce) {
  FreeNames names(table({}, {}));
  EXPECT_EQ(names.copy_of("box"), "box copy");
  EXPECT_EQ(names.copy_of("box"), "box copy 2");
  EXPECT_EQ(names.another("box"), "box 2");
  EXPECT_EQ(names.another("box"), "box 3");
}

TEST(FreeNames, OfACopyOfACopyAreThoseOfACopy) {
  FreeNames names(table({"box copy", "box copy 2[0]"}, {}));
  EXPECT_EQ(names.copy_of("box copy"), "box copy 3");
  EXPECT_EQ(names.copy_of("box copy 2"), "box copy 4");
  EXPECT_EQ(names.copy_of("box 2"), "box 2 copy");
  EXPECT_EQ(names.copy_of("box2"), "box2 copy");
  EXPECT_EQ(names.copy_of(" copy"), " copy copy");
  EXPECT_EQ(names.copy_of("2"), "2 copy");
  EXPECT_EQ(names.copy_of("room[3]"), "room[3] copy");
}

TEST(FreeNames, OfMaterialsAreApart) {
  SceneTable scene = table({"white copy"}, {});
  EXPECT_EQ(free_copy_of_material(scene, "white"), "white copy");
  scene.materials.push_back({"white copy", {}, {}});
  EXPECT_EQ(free_copy_of_material(scene, "white"), "white copy 2");
  EXPECT_EQ(free_copy_of_material(scene, "white copy"), "white copy 2");
}

}  // namespace
}  // namespace hottel::free_names_test

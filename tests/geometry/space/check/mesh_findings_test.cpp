#include "geometry/space/check/mesh_findings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/geometry/space/check/small_scene.h"

namespace hottel::mesh_findings_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing_space::add;
using testing_space::add_box;
using testing_space::empty_scene;
using testing_space::q;
using testing_space::told;
using testing_space::unit_room;

Scene3 box(bool is_room) {
  Scene3 scene = empty_scene();
  add_box(scene, "box", {0, 0, 0}, {1, 1, 1}, is_room);
  return scene;
}

void reverse(Scene3& scene, std::size_t s) {
  std::reverse(scene.polygons[s].points.begin(), scene.polygons[s].points.end());
}

// Takes the polygon of that number away.
void remove(Scene3& scene, std::size_t s) {
  scene.surfaces.erase(scene.surfaces.begin() + static_cast<std::ptrdiff_t>(s));
  scene.polygons.erase(scene.polygons.begin() + static_cast<std::ptrdiff_t>(s));
}

std::vector<std::string> told_of(const Scene3& scene) { return told(scene, mesh_findings(scene, find_meshes(scene))); }

TEST(EdgeStretches3, OfACubeAreUsedOnceInEachDirection) {
  const std::vector<EdgeStretch3> stretches = find_edge_stretches(unit_room().polygons);
  EXPECT_EQ(stretches.size(), 12u);
  for (const EdgeStretch3& stretch : stretches) {
    ASSERT_EQ(stretch.uses.size(), 2u);
    EXPECT_NE(stretch.uses[0].is_reversed, stretch.uses[1].is_reversed);
  }
}

TEST(EdgeStretches3, AreCutWhereOthersEnd) {
  Scene3 scene = empty_scene();
  add(scene, "long", {{0, 0, 0}, {3, 0, 0}, {0, 1, 0}});
  add(scene, "short", {{2, 0, 0}, {1, 0, 0}, {1, 0, 1}});
  const std::vector<EdgeStretch3> stretches = find_edge_stretches(scene.polygons);
  ASSERT_EQ(stretches.size(), 7u);
  EXPECT_EQ(stretches[1].from, (Point3{1, 0, 0}));
  EXPECT_EQ(stretches[1].to, (Point3{2, 0, 0}));
  EXPECT_THAT(stretches[1].uses, ElementsAre(EdgeUse3{0, false}, EdgeUse3{1, true}));
}

TEST(EdgeStretches3, ASegmentIsCoveredByPolygonsTogether) {
  Scene3 scene = empty_scene();
  add(scene, "a", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  add(scene, "b", {{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}});
  const Side3 across{{q("1/2"), q("1/2"), 0}, {q("3/2"), q("3/4"), 0}};
  EXPECT_TRUE(is_covered(across, scene.polygons, {0, 1}));
  EXPECT_FALSE(is_covered(across, scene.polygons, {0}));
  EXPECT_TRUE(is_covered({{0, 0, 0}, {2, 0, 0}}, scene.polygons, {0, 1}));
  EXPECT_FALSE(is_covered({{q("1/2"), q("1/2"), 0}, {q("1/2"), q("1/2"), 1}}, scene.polygons, {0, 1}));
}

TEST(Meshes3, ClosedOnesAreCleanAndHaveTheirFrontsOutsideOrInside) {
  for (const bool is_room : {false, true}) {
    const Meshes3 meshes = find_meshes(box(is_room));
    EXPECT_THAT(told_of(box(is_room)), IsEmpty());
    EXPECT_THAT(meshes.is_closed, ElementsAre(1));
    EXPECT_THAT(meshes.is_room, ElementsAre(is_room));
    EXPECT_THAT(meshes.bare, IsEmpty());
  }
  EXPECT_THAT(told_of(unit_room()), IsEmpty()) << "walls of single polygons";
}

TEST(Meshes3, AMissingFaceIsAHoleUnlessItsEdgesLieOnSomething) {
  Scene3 scene = box(false);
  remove(scene, 0);
  const Meshes3 meshes = find_meshes(scene);
  ASSERT_EQ(meshes.holes.size(), 1u);
  EXPECT_EQ(meshes.holes[0].edges.size(), 4u);
  EXPECT_EQ(meshes.bare.size(), 4u);
  EXPECT_THAT(told_of(scene), ElementsAre("warning open-mesh box.front box.rear box.left box.right"));
  add(scene, "floor", {{-1, -1, 0}, {2, -1, 0}, {2, 2, 0}, {-1, 2, 0}});
  EXPECT_THAT(told_of(scene), IsEmpty()) << "it stands on a floor";
}

TEST(Meshes3, TwoHolesAreTwo) {
  Scene3 scene = box(false);
  for (const std::size_t s : {0u, 1u}) scene.polygons[s].points.pop_back();  // half of the bottom, half of the top
  EXPECT_EQ(find_meshes(scene).holes.size(), 2u);
}

TEST(Meshes3, JunctionsWithinAMeshAreNoHoles) {
  Scene3 scene = box(false);
  scene.polygons[0].points = {{0, 0, 0}, {0, 1, 0}, {q("1/3"), 1, 0}, {q("1/3"), 0, 0}};
  add(scene, "rest", {{q("1/3"), 0, 0}, {q("1/3"), 1, 0}, {1, 1, 0}, {1, 0, 0}}, "box");
  EXPECT_THAT(told_of(scene), IsEmpty());
  EXPECT_THAT(find_meshes(scene).is_closed, ElementsAre(1));
}

TEST(Meshes3, APolygonThatIsUpsideDownIsToldAlone) {
  for (Scene3 scene : {box(false), unit_room()}) {
    reverse(scene, 3);
    EXPECT_THAT(told_of(scene), ElementsAre("warning upside-down " + scene.surfaces[3].name));
  }
}

TEST(Meshes3, TwoFrontsThatDisagreeAreToldWhereNeitherIsCertain) {
  Scene3 scene = empty_scene();
  add(scene, "a", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, "fold");
  add(scene, "b", {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}, "fold");
  EXPECT_THAT(told_of(scene), ElementsAre("warning opposed-fronts a b"));
}

TEST(Meshes3, EdgesOfManyAreNoted) {
  Scene3 scene = empty_scene();
  add_box(scene, "boxes", {0, 0, 0}, {1, 1, 1}, false);
  for (Surface& surface : scene.surfaces) surface.name += "_1";
  add_box(scene, "boxes", {1, 1, 0}, {2, 2, 1}, false);
  EXPECT_THAT(told_of(scene), ElementsAre("note crowded-edge boxes.rear_1 boxes.right_1 boxes.front boxes.left"));
}

}  // namespace
}  // namespace hottel::mesh_findings_test

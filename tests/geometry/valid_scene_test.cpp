// Scenes that are known to be valid, in both dimensions.
#include <gtest/gtest.h>

#include <string>
#include <type_traits>

#include "geometry/plane/scene/division.h"
#include "geometry/space/scene/division.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"

namespace hottel::valid_scene_test {
namespace {

const std::string kScenes = HOTTEL_SOURCE_DIR "/scenes/";

static_assert(std::is_convertible_v<ValidScene2, Scene2> && std::is_convertible_v<Scene2, ValidScene2>);
static_assert(std::is_convertible_v<ValidScene3, Scene3> && std::is_convertible_v<Scene3, ValidScene3>);
static_assert(!std::is_convertible_v<ValidScene2, SceneTable> && !std::is_convertible_v<ValidScene3, SceneTable>);

TEST(ValidScene2, IsMadeByValidationAlone) {
  Scene2 scene = read_scene_2(kScenes + "analytic/strip_obstructed.json");
  EXPECT_EQ(ValidScene2(scene)->edges, scene.edges);
  scene.edges[0].to = scene.edges[0].from;
  EXPECT_THROW(ValidScene2{scene}, InputError);
}

TEST(ValidScene3, IsMadeByValidationAlone) {
  Scene3 scene = read_scene_3(kScenes + "space/cube.json");
  EXPECT_EQ(ValidScene3(scene)->polygons, scene.polygons);
  scene.polygons[0].points.resize(2);
  EXPECT_THROW(ValidScene3{scene}, InputError);
}

template <class AnyValidScene, class Grid>
void expect_that_changes_leave_it_valid(AnyValidScene scene, const Grid& good, const Grid& bad) {
  divide_into(scene, 3);
  for (const Surface& surface : scene->surfaces) EXPECT_EQ(surface.elements, 3u);
  EXPECT_EQ(divide_by_length(scene, Rational(1, 1000), 5), 0u);
  EXPECT_EQ(scene->surfaces[0].elements, 3u);
  EXPECT_THROW(divide_into(scene, kMaxElements + 1), ContractViolation);
  EXPECT_THROW(divide_by_length(scene, 1, kMaxElements + 1), ContractViolation);
  scene.set_grids({good});
  EXPECT_THROW(scene.set_grids({bad}), InputError);
  EXPECT_EQ(scene->grids.size(), 1u);
  EXPECT_EQ(scene->grids[0], good);
  EXPECT_NO_THROW(validate(*scene));
}

TEST(ValidScene2, IsLeftValidByWhatCanBeChanged) {
  expect_that_changes_leave_it_valid(read_scene_2(kScenes + "analytic/strip_obstructed.json"),
                                     Grid2{{0, 0}, {1, 1}, 2, 2}, Grid2{{0, 0}, {0, 1}, 2, 2});
}

TEST(ValidScene3, IsLeftValidByWhatCanBeChanged) {
  expect_that_changes_leave_it_valid(read_scene_3(kScenes + "space/cube.json"),
                                     Grid3{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 2, 2},
                                     Grid3{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, 2, 2});
}

TEST(ValidScene2, IsNotDividedAgainBelowItsTrees) {
  Scene2 scene = read_scene_2(kScenes + "analytic/strip_obstructed.json");
  scene.surfaces[0].trees.front = uniform_leaves(1, 2, 1);
  ValidScene2 valid(scene);
  EXPECT_THROW(divide_into(valid, 2), ContractViolation);
  EXPECT_EQ(valid->surfaces[0].trees, scene.surfaces[0].trees);
}

}  // namespace
}  // namespace hottel::valid_scene_test

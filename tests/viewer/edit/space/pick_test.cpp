// What lies under the mouse in space, exactly.
#include "viewer/edit/space/pick.h"

#include <gtest/gtest.h>

#include "tests/viewer/edit/space/edited_scenes.h"

namespace hottel::pick_test {
namespace {

using testing_edits::furnished;

Pointer3 at(const Direction3& place) {
  Pointer3 pointer{.eye = {2, 0.25, 1.5}, .pixel = 0.002};
  pointer.at = pointer.seen(place);
  return pointer;
}

std::string seen(const Scene3& scene, const Direction3& place) {
  const auto pick = ScenePick3(scene).at(at(place));
  return pick ? scene.surfaces[pick->face.surface].name + (pick->face.is_back ? ":back" : "") : "";
}

TEST(ScenePick3, FindsWhatTheRayMeetsFirst) {
  const Scene3 scene = furnished();
  EXPECT_EQ(seen(scene, {1.5, 1, 0.5}), "box.a");
  EXPECT_EQ(seen(scene, {3.5, 4, 2.5}), "rear");
  EXPECT_EQ(seen(scene, {0.6, 3, 1.4}), "frame");
  EXPECT_EQ(seen(scene, {1.15, 3, 0.9}), "rear") << "through the hole";
  EXPECT_EQ(seen(scene, {2, 1, -0.5}), "floor");
}

// (1)
TEST(ScenePick3, TakesThePatchBeforeWhatItLiesOn) {
  const Scene3 scene = furnished();
  EXPECT_EQ(seen(scene, {2.8, 4, 1.5}), "window");
  EXPECT_EQ(seen(scene, {2.25, 4, 1.5}), "picture");
}

TEST(ScenePick3, IsExactAtBorders) {
  const Scene3 scene = furnished();
  Pointer3 pointer{.eye = {2, 0, 0.5}};
  pointer.at = {0, 0};  // straight along the edge between box.a and box.b
  EXPECT_EQ(ScenePick3(scene).at(pointer)->place, (Point3{2, 1, Rational(1, 2)}));
  pointer.eye.x = std::nextafter(2.0, 3.0);
  EXPECT_EQ(ScenePick3(scene).at(pointer)->place.y, 4) << "one double beside it";
}

TEST(ScenePick3, LeavesOutWhatIsToBeLeftOut) {
  const Scene3 scene = furnished();
  std::vector<bool> is_left_out(scene.surfaces.size());
  is_left_out[*scene.find("box.a")] = true;
  const auto pick = ScenePick3(scene).at(at({1.5, 1, 0.5}), is_left_out);
  EXPECT_EQ(scene.surfaces[pick->face.surface].name, "floor") << "whose front is seen, not the bottom's back";
  EXPECT_FALSE(pick->face.is_back);
}

TEST(CornerAt, IsTheCornerThatIsSeenNearest) {
  const Scene3 scene = furnished();
  const std::vector<std::uint32_t> box{*scene.find("box.a")};
  EXPECT_EQ(corner_at(scene, box, at({1.005, 1, 0.995})), (Point3{1, 1, 1}));
  EXPECT_FALSE(corner_at(scene, box, at({1.3, 1, 0.7})));
}

}  // namespace
}  // namespace hottel::pick_test

// The axes beside what a camera sees.
#include "viewer/picture/space/tripod.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "io/scene/scene_json.h"
#include "viewer/picture/recording_canvas.h"

namespace hottel::tripod_test {
namespace {

Scene3 scene() {
  return parse_scene_3(R"({"hottel": 1, "dimension": 3, "materials": {"m": {}}, "polygons": [
    {"points": [[-1, 0, 2], ["1/3", 0, 2], ["1/3", 5, 2]], "material": "m"}]})",
                       "scene.json");
}

RecordingCanvas drawn(const Camera3& camera) {
  RecordingCanvas canvas(300, 100);
  Tripod3(scene(), camera, "ft").draw(canvas, {10, 20}, 1);
  return canvas;
}

TEST(Tripod3, SaysHowFarTheSceneReaches) {
  const RecordingCanvas canvas = drawn({.eye = {3, -4, 5}, .target = {0, 0, 0}});
  EXPECT_TRUE(canvas.wrote("x -1 to 0.333333 ft"));
  EXPECT_TRUE(canvas.wrote("y 0 to 5 ft"));
  EXPECT_TRUE(canvas.wrote("z 2 to 2 ft"));
}

TEST(Tripod3, ArrowsPointWhereTheAxesDo) {
  // Along y: x to the right, z upwards, y into the picture.
  const RecordingCanvas canvas = drawn({.eye = {0, -5, 0}, .target = {0, 0, 0}});
  const auto arrows = canvas.calls(Mark::kAxis, RecordingCanvas::Kind::kStroke);
  ASSERT_EQ(arrows.size(), 2u);
  EXPECT_GT(arrows[0].points[1].x, arrows[0].points[0].x + 10);
  EXPECT_NEAR(arrows[0].points[1].y, arrows[0].points[0].y, 1e-9);
  EXPECT_LT(arrows[1].points[1].y, arrows[1].points[0].y - 10);
  EXPECT_EQ(canvas.calls(Mark::kAxis, RecordingCanvas::Kind::kDisc).size(), 1u) << "y is seen end on";
}

TEST(Tripod3, NamesDoNotLieOnEachOther) {
  for (const Point3& eye : {Point3{1, -9, 6}, Point3{-1, -9, 6}, Point3{0, -9, 6}, Point3{1, -3, 9}}) {
    const RecordingCanvas canvas = drawn({.eye = eye, .target = {0, 0, 1}});
    std::vector<Pixel> names;
    for (const auto& call : canvas.calls(Mark::kAxis, RecordingCanvas::Kind::kText))
      if (call.text.size() == 1) names.push_back({(call.points[0].x + call.points[1].x) / 2, call.points[1].y});
    ASSERT_EQ(names.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = i + 1; j < 3; ++j)
        EXPECT_GT(std::hypot(names[i].x - names[j].x, names[i].y - names[j].y), 8) << names[i].x << ' ' << names[i].y;
  }
}

TEST(Tripod3, StaysInItsRoom) {
  for (const Point3& eye : {Point3{3, -4, 5}, Point3{-3, 4, -5}, Point3{1, 1, 9}, Point3{-5, 1, 1}}) {
    const RecordingCanvas canvas = drawn({.eye = eye, .target = {0, 0, 0}});
    const double wide = Tripod3(scene(), {.eye = eye, .target = {0, 0, 0}}, "ft").width(canvas, 1);
    for (const auto& call : canvas.calls())
      for (const Pixel& p : call.points) {
        EXPECT_TRUE(6 <= p.x && p.x <= 10 + wide + 1e-9) << p.x;
        EXPECT_TRUE(12 <= p.y && p.y <= 20 + 66) << p.y;
      }
  }
}

}  // namespace
}  // namespace hottel::tripod_test

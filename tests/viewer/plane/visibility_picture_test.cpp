#include <gmock/gmock.h>

#include <array>
#include <vector>

#include "geometry/plane/visibility/point_view.h"
#include "tests/viewer/plane/drawn_scenes.h"
#include "viewer/picture/plane/scene_sheet.h"
#include "viewer/picture/plane/visibility_painter.h"

namespace hottel::visibility_picture_test {
namespace {

using testing::StartsWith;
using Kind = RecordingCanvas::Kind;

template <class Painter>
RecordingCanvas drawn(const Painter& painter) {
  RecordingCanvas canvas(painter.width(), painter.height());
  painter.draw(canvas);
  return canvas;
}

TEST(VisibilityPicture2, ShowsTheRegionTheRaysAndTheEye) {
  const PreparedScene2 scene = prepare(furnished_room());
  const VisibilityDrawing2 drawing{
      .eye = {0.5, 1.5}, .polygon = {{0, 0}, {1, 1}, {1, 2}, {0, 3}}, .rays_to = {{1, 1}, {1, 2}}};
  const RecordingCanvas canvas = drawn(VisibilityPainter2(scene, drawing));
  ASSERT_EQ(canvas.count(Mark::kLight), 1u);
  EXPECT_EQ(canvas.calls(Mark::kLight)[0].points.size(), 4u);
  EXPECT_LT(canvas.calls(Mark::kLight)[0].colour.a, 1);
  EXPECT_EQ(canvas.count(Mark::kRay), 2u);
  EXPECT_EQ(canvas.calls(Mark::kCritical, Kind::kCircle).size(), 2u);
  EXPECT_GE(canvas.count(Mark::kEye), 1u);
  EXPECT_EQ(canvas.count(Mark::kEdge), scene.scene.surfaces.size());
  EXPECT_TRUE(inside(canvas));
}

TEST(VisibilityPicture2, CutsWhatReachesOutOfThePicture) {
  const PreparedScene2 scene = prepare(furnished_room());
  const VisibilityDrawing2 drawing{.eye = {9, 1},  // outside the room: the picture grows to show it
                                   .polygon = {{-1e6, -1e6}, {1e6, -1e6}, {1e6, 1e6}, {-1e6, 1e6}},
                                   .rays_to = {{1e6, 3e5}, {0, 3}}};
  const RecordingCanvas canvas = drawn(VisibilityPainter2(scene, drawing));
  EXPECT_TRUE(inside(canvas));
  EXPECT_EQ(canvas.count(Mark::kRay), 2u);
  EXPECT_EQ(canvas.calls(Mark::kCritical, Kind::kCircle).size(), 1u);
}

// Whether a polygon has a place inside, by the crossings of a ray to the right.
bool contains(const std::vector<std::array<double, 2>>& polygon, double x, double y) {
  bool is_inside = false;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const auto &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
    if ((p[1] > y) != (q[1] > y) && x < p[0] + (y - p[1]) / (q[1] - p[1]) * (q[0] - p[0])) is_inside = !is_inside;
  }
  return is_inside;
}

TEST(VisibilityDrawing2, ReachesAllAroundTowardsTheSky) {
  const PreparedScene2 scene = prepare(furnished_room());
  for (const Point2& eye : {Point2{9, 1}, {-5, 2}, {2, 9}, {2, -7}, {Rational(1) / 2, Rational(1000001) / -1000000}}) {
    const VisibilityDrawing2 drawing = drawing_of(point_view(scene, eye).polygon);
    const double x = to_double(eye.x), y = to_double(eye.y);
    const double away_x = x > 4 ? 1 : x < 0 ? -1 : 0, away_y = y > 4 ? 1 : y < 0 ? -1 : 0;
    for (const double far : {1e-3, 1.0, 100.0})
      EXPECT_TRUE(contains(drawing.polygon, x + far * away_x, y + far * away_y));
    EXPECT_TRUE(contains(drawing.polygon, x + 50 * away_y, y + 50 * away_x));
    EXPECT_TRUE(contains(drawing.polygon, x - 50 * away_y, y - 50 * away_x));
    EXPECT_FALSE(contains(drawing.polygon, 0.1, 0.1));
    EXPECT_FALSE(contains(drawing.polygon, x - 50 * away_x, y - 50 * away_y));
  }
}

TEST(PairPicture2, HighlightsBothEdgesAndTheCriticalPoints) {
  const PreparedScene2 scene = prepare(furnished_room());
  const PairDrawing2 drawing{.a = {1},
                             .b = {kWindow},
                             .critical_on_a = {{1, 3}, {2.5, 3}, {3.5, 3}},
                             .lines = {{{1, 3}, {1, 0}}, {{3.5, 3}, {3, 0}}}};
  const RecordingCanvas canvas = drawn(PairPainter2(scene, drawing));
  EXPECT_EQ(canvas.count(Mark::kTarget), 2u);
  EXPECT_NE(canvas.calls(Mark::kTarget)[0].colour, canvas.calls(Mark::kTarget)[1].colour);
  EXPECT_EQ(canvas.calls(Mark::kCritical, Kind::kCircle).size(), 3u);
  EXPECT_EQ(canvas.count(Mark::kRay), 2u);
  EXPECT_EQ(canvas.count(Mark::kEdge), scene.scene.surfaces.size() - 2);
  EXPECT_TRUE(canvas.wrote("A"));
  EXPECT_TRUE(canvas.wrote("B"));
  EXPECT_TRUE(inside(canvas));
}

TEST(PairPicture2, LabelsTheSideThatIsMeant) {
  const PreparedScene2 scene = prepare(furnished_room());
  PairDrawing2 drawing{.a = {kScreen}, .b = {kWindow}};
  const auto label = [&] {
    const auto box = drawn(PairPainter2(scene, drawing)).calls(Mark::kLabel).back().points;
    return (box[0].x + box[1].x) / 2;
  };
  const double screen = SceneSheet2(scene, drawing.sheet, 44).from(kScreen).x;
  EXPECT_GT(label(), screen);  // the screen points up: its front looks to the right
  drawing.a.is_back = true;
  EXPECT_LT(label(), screen);
}

TEST(VisibilityPicture2, BecomesAFileOfEitherFormat) {
  const PreparedScene2 scene = prepare(furnished_room());
  EXPECT_THAT(visibility_picture_2(scene, {.eye = {1, 1}}, PictureFormat::kPng), StartsWith("\x89PNG"));
  EXPECT_THAT(visibility_picture_2(scene, {.eye = {1, 1}}, PictureFormat::kSvg), StartsWith("<?xml"));
  EXPECT_THAT(pair_picture_2(scene, {.a = {0}, .b = {1}}, PictureFormat::kSvg), StartsWith("<?xml"));
}

}  // namespace
}  // namespace hottel::visibility_picture_test

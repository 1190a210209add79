#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "kernel/support/failure.h"
#include "tests/viewer/plane/drawn_scenes.h"
#include "viewer/picture/colour_map.h"
#include "viewer/picture/palette.h"
#include "viewer/picture/plane/scene_painter.h"
#include "viewer/picture/plane/scene_sheet.h"

namespace hottel::scene_picture_test {
namespace {

using testing::StartsWith;
using Kind = RecordingCanvas::Kind;

RecordingCanvas drawn(const Scene2& scene, const ScenePicture2& picture) {
  const PreparedScene2 prepared = prepare(scene);
  const ScenePicturePainter2 painter(prepared, picture);
  RecordingCanvas canvas(painter.width(), painter.height());
  painter.draw(canvas);
  return canvas;
}

ScenePicture2 coloured() {
  ScenePicture2 picture;
  picture.sheet = {.title = "A room", .subtitle = "and its table"};
  picture.targets = {kWindow};
  picture.target_label = "window";
  picture.colouring.emplace();
  picture.colouring->title = "fraction of the window seen";
  return picture;
}

// On which side of from -> to the middle of a stripe lies: positive on the right, in pixels.
double depth(const Scene2& scene, const ScenePicture2& picture, std::uint32_t surface,
             const std::vector<Pixel>& stripe) {
  const SceneSheet2 sheet(prepare(scene), picture.sheet, 62);
  const Pixel a = sheet.from(surface), b = sheet.to(surface);
  Pixel middle;
  for (const Pixel& p : stripe) middle = {middle.x + p.x / 4, middle.y + p.y / 4};
  return ((b.x - a.x) * (middle.y - a.y) - (b.y - a.y) * (middle.x - a.x)) / std::hypot(b.x - a.x, b.y - a.y);
}

TEST(ScenePicture2, HasOneStripeForEachFaceWithAValue) {
  const Scene2 scene = furnished_room();
  ScenePicture2 picture = coloured();
  picture.colouring->front.assign(scene.surfaces.size(), 0.5);
  picture.colouring->front[kWindow] = std::nullopt;
  picture.colouring->front[kTableBottom] = std::numeric_limits<double>::quiet_NaN();
  picture.colouring->back.assign(scene.surfaces.size(), 0.25);  // only the screen has a material on its back
  const RecordingCanvas canvas = drawn(scene, picture);
  EXPECT_EQ(canvas.count(Mark::kStripe), scene.surfaces.size() - 2 + 1);
  EXPECT_EQ(canvas.count(Mark::kEdge), scene.surfaces.size() - 1);
  EXPECT_EQ(canvas.count(Mark::kTarget), 1u);
  EXPECT_EQ(canvas.count(Mark::kEmitter), 0u);
}

// Below stripes lie the same, larger, within the border of all.
TEST(ScenePicture2, NothingShinesThroughBetweenStripes) {
  const Scene2 scene = furnished_room();
  ScenePicture2 picture = coloured();
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s)
    picture.colouring->front.emplace_back(static_cast<double>(s) / static_cast<double>(scene.surfaces.size()));
  const RecordingCanvas canvas = drawn(scene, picture);
  std::size_t below = 0;
  for (const auto& call : canvas.calls(Mark::kPaper))
    for (const auto& stripe : canvas.calls(Mark::kStripe)) below += call.colour == stripe.colour && !call.clip.empty();
  EXPECT_EQ(below, canvas.count(Mark::kStripe));
}

TEST(ScenePicture2, StripesLieOnTheirOwnSide) {
  const Scene2 scene = furnished_room();
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s)
    for (const bool back : {false, true}) {
      if (back && !scene.surfaces[s].back) continue;
      ScenePicture2 picture = coloured();
      std::vector<std::optional<double>>& values = back ? picture.colouring->back : picture.colouring->front;
      values.resize(s);
      values.push_back(0.7);
      const auto stripes = drawn(scene, picture).calls(Mark::kStripe);
      ASSERT_EQ(stripes.size(), 1u);
      EXPECT_EQ(stripes[0].colour, map_colour(0.7));
      const double pixels = depth(scene, picture, s, stripes[0].points);
      EXPECT_TRUE(back ? pixels < -1 : pixels > 1) << s << " " << pixels;
    }
}

TEST(ScenePicture2, StripesOfACornerShareTheMitre) {
  const Scene2 scene = furnished_room();
  ScenePicture2 picture = coloured();
  picture.colouring->front = {0.1, 0.2};  // the left and the upper wall
  const auto stripes = drawn(scene, picture).calls(Mark::kStripe);
  ASSERT_EQ(stripes.size(), 2u);
  EXPECT_EQ(stripes[0].points[1], stripes[1].points[0]);
  EXPECT_NEAR(stripes[0].points[2].x, stripes[1].points[3].x, 1e-9);
  EXPECT_NEAR(stripes[0].points[2].y, stripes[1].points[3].y, 1e-9);
}

TEST(ScenePicture2, StripesAreClippedToTheirRoomAndHiddenBySolids) {
  const Scene2 scene = furnished_room();
  ScenePicture2 picture = coloured();
  picture.colouring->front.assign(scene.surfaces.size(), 1.0);
  const RecordingCanvas canvas = drawn(scene, picture);
  std::size_t last_stripe = 0, solid = 0;
  for (std::size_t k = 0; k < canvas.calls().size(); ++k) {
    const auto& call = canvas.calls()[k];
    if (call.mark == Mark::kStripe) {
      last_stripe = k;
      EXPECT_EQ(call.clip.size(), 6u);  // the corners of the room
    }
    if (call.mark == Mark::kSolid) solid = k;
  }
  EXPECT_LT(last_stripe, solid);
}

TEST(ScenePicture2, NothingLeavesThePicture) {
  for (const std::uint32_t width : {200u, 333u, 1600u, 4000u}) {
    const Scene2 scene = furnished_room();
    ScenePicture2 picture = coloured();
    picture.sheet.width = width;
    picture.sheet.title =
        "A title that is much too long for a picture of any of these widths, however large one makes it, "
        "and still has to be shown in full";
    picture.colouring->front.assign(scene.surfaces.size(), 0.5);
    EXPECT_TRUE(inside(drawn(scene, picture))) << width;
    picture.colouring.reset();
    EXPECT_TRUE(inside(drawn(scene, picture))) << width;
  }
}

TEST(ScenePicture2, HasALegendIffItIsColoured) {
  const Scene2 scene = furnished_room();
  ScenePicture2 picture = coloured();
  EXPECT_TRUE(drawn(scene, picture).wrote("fraction of the window seen"));
  EXPECT_TRUE(drawn(scene, picture).wrote("window"));
  EXPECT_TRUE(drawn(scene, picture).wrote("A room"));
  EXPECT_EQ(drawn(scene, picture).calls(Mark::kLegend, Kind::kImage).size(), 1u);
  picture.colouring.reset();
  EXPECT_EQ(drawn(scene, picture).calls(Mark::kLegend, Kind::kImage).size(), 0u);
}

TEST(ScenePicture2, PlainPlansShowWhatEmits) {
  const RecordingCanvas canvas = drawn(furnished_room(), {});
  const auto emitters = canvas.calls(Mark::kEmitter);
  ASSERT_EQ(emitters.size(), 1u);
  EXPECT_GT(depth(furnished_room(), {}, kWindow, emitters[0].points), 1);
  EXPECT_EQ(canvas.count(Mark::kStripe), 0u);
  EXPECT_TRUE(canvas.wrote("emits light"));
}

TEST(ScenePicture2, PixelsLieOverTheFloorAndUnderTheFurniture) {
  ScenePicture2 picture;
  picture.pixels = std::make_shared<ScenePixels2>(ScenePixels2{Raster(1, 1, 0xFFFFFF00), {0, 0}, {4, 3}, false});
  const RecordingCanvas canvas = drawn(furnished_room(), picture);
  std::vector<Mark> order;
  for (const auto& call : canvas.calls())
    if (call.mark == Mark::kFloor || call.mark == Mark::kLight || call.mark == Mark::kSolid) order.push_back(call.mark);
  EXPECT_THAT(order, testing::ElementsAre(Mark::kFloor, Mark::kLight, Mark::kSolid));
  const auto floor = canvas.calls(Mark::kFloor)[0].points, light = canvas.calls(Mark::kLight)[0].points;
  EXPECT_NEAR(light[0].x, floor[1].x, 1e-9);  // top left corner
  EXPECT_NEAR(light[0].y, floor[1].y, 1e-9);
}

// Cells of a room 4 wide, whose values grow from left to right; the screen stands at x = 1, from y = 1 to 2.
TEST(ScenePicture2, ContoursOfPixelsRunWhereTheseHaveTheirLevelAndEndAtWalls) {
  const Scene2 scene = furnished_room();
  ScenePicture2 picture;
  auto pixels = std::make_shared<ScenePixels2>(ScenePixels2{Raster(80, 60, 0xFFFFFF00), {0, 0}, {4, 3}, false});
  for (int row = 0; row < 60; ++row)
    for (int column = 0; column < 80; ++column) pixels->values.push_back(1 + (column + 0.5) / 80);
  picture.pixels = pixels;
  EXPECT_EQ(drawn(scene, picture).count(Mark::kCurve), 0u);
  pixels->levels = {1.25, 1.5};
  const SceneSheet2 sheet(prepare(scene), picture.sheet, 62);
  const Pixel screen = sheet.from(kScreen);
  const double cell = (sheet.frame().at(std::array{4.0, 0.0}).x - sheet.frame().at(std::array{0.0, 0.0}).x) / 80;
  std::size_t at_screen = 0, in_the_middle = 0;
  const RecordingCanvas canvas = drawn(scene, picture);
  for (const auto& call : canvas.calls(Mark::kCurve)) {
    if (call.kind != Kind::kStroke) continue;
    const double from_screen = std::fabs(call.points[0].x - screen.x) / cell, from_middle = from_screen - 20;
    ++(from_screen < 10 ? at_screen : in_the_middle);
    EXPECT_LT(std::min(from_screen, std::fabs(from_middle)), 1);
    for (const Pixel& p : call.points)
      EXPECT_TRUE(from_screen > 1 || p.y > screen.y - 1 || p.y < sheet.to(kScreen).y + 1) << "through the screen";
  }
  EXPECT_GE(at_screen, 4u) << "above and below it, twice each";
  EXPECT_GE(in_the_middle, 2u);
  EXPECT_TRUE(canvas.wrote("1.5"));
}

// The grid may reach far beyond the sheet.
TEST(ScenePicture2, ContoursOfPixelsEndWithTheSheet) {
  ScenePicture2 picture;
  auto pixels = std::make_shared<ScenePixels2>(ScenePixels2{Raster(3, 1, 0xFFFFFF00), {-1e7, -1e7}, {1e7, 1e7}, false});
  pixels->values = {1, 2, 3};
  pixels->levels = {1.5};
  picture.pixels = pixels;
  EXPECT_GT(drawn(furnished_room(), picture).count(Mark::kEdge), 0u);
}

// A box on the floor: what lies beneath it has no colour, on either side of the contact.
TEST(ScenePicture2, CoveredPartsOfFacesHaveNoStripe) {
  DrawnScene drawing;
  drawing.edge({4, 0}, {0, 0});                      // a floor, its front looks up
  drawing.closed({{1, 0}, {2, 0}, {2, 1}, {1, 1}});  // 1: the bottom
  drawing.edge({Rational(5, 4), Rational(1, 2)}, {Rational(7, 4), Rational(1, 2)}, 0, 0);  // drawn inside the box
  ScenePicture2 picture = coloured();
  picture.targets.clear();
  picture.colouring->front.assign(6, 0.5);
  picture.colouring->back.assign(6, 0.5);
  const RecordingCanvas canvas = drawn(drawing.scene, picture);
  const auto stripes = canvas.calls(Mark::kStripe);
  ASSERT_EQ(stripes.size(), 2u + 3u);  // the floor left and right of the box, the sides of the box and its top
  const SceneSheet2 sheet(prepare(drawing.scene), picture.sheet, 62);
  const double left = sheet.from(1).x, right = sheet.to(1).x, unit = right - left;
  for (std::size_t k = 0; k < 2; ++k)
    for (const Pixel& p : stripes[k].points) EXPECT_TRUE(p.x <= left + 1e-9 || p.x >= right - 1e-9) << p.x / unit;
  EXPECT_EQ(canvas.count(Mark::kSolid), 1u);
}

TEST(ScenePicture2, EmptyAndTinyScenesAreDrawn) {
  EXPECT_TRUE(inside(drawn(Scene2{}, {})));
  DrawnScene single;
  single.edge({0, 0}, {0, 1}, 1);
  EXPECT_TRUE(inside(drawn(single.scene, {})));
}

TEST(ScenePicture2, CrowdedCornersKeepStripesShort) {
  DrawnScene star;
  for (int k = 0; k < 40; ++k)
    star.edge({0, 0},
              {Rational(std::lround(1000 * std::cos(k * 0.157))), Rational(std::lround(1000 * std::sin(k * 0.157)))}, 0,
              0);
  ScenePicture2 picture = coloured();
  picture.targets.clear();
  picture.colouring->front.assign(40, 0.5);
  picture.colouring->back.assign(40, 0.5);
  const RecordingCanvas canvas = drawn(star.scene, picture);
  EXPECT_EQ(canvas.count(Mark::kStripe), 80u);
  EXPECT_TRUE(inside(canvas));
}

TEST(ScenePicture2, BecomesAFileOfEitherFormat) {
  EXPECT_THAT(scene_picture_2(prepare(furnished_room()), coloured(), PictureFormat::kPng), StartsWith("\x89PNG"));
  EXPECT_THAT(scene_picture_2(prepare(furnished_room()), coloured(), PictureFormat::kSvg), StartsWith("<?xml"));
}

TEST(ScenePicture2, RefusesWidthsOutOfRange) {
  ScenePicture2 picture;
  for (const std::uint32_t width : {0u, kMinPictureWidth - 1, kMaxPictureSide + 1}) {
    picture.sheet.width = width;
    EXPECT_THROW(scene_picture_2(prepare(furnished_room()), picture, PictureFormat::kPng), UsageError);
  }
}

}  // namespace
}  // namespace hottel::scene_picture_test

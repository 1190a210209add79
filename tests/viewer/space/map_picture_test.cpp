// The sphere of directions, drawn.
#include "viewer/picture/space/map_picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "kernel/support/failure.h"
#include "viewer/picture/recording_canvas.h"

namespace hottel::map_picture_test {
namespace {

using Kind = RecordingCanvas::Kind;

Direction3 unit(double x, double y, double z) {
  const double length = std::sqrt(x * x + y * y + z * z);
  return {x / length, y / length, z / length};
}

// A square around (0, 1, 0), from -s to s, in so many strips of one face.
MapDrawing3 square(double s, int strips) {
  MapDrawing3 drawing{.pieces = {}, .colours = {{0.5, 0.5, 0.5}}, .title = "a square"};
  for (int k = 0; k < strips; ++k) {
    const double left = -s + 2 * s * k / strips, right = -s + 2 * s * (k + 1) / strips;
    drawing.pieces.push_back({{unit(left, 1, -s), unit(right, 1, -s), unit(right, 1, s), unit(left, 1, s)}, 0});
  }
  return drawing;
}

RecordingCanvas drawn(const MapDrawing3& drawing) {
  const MapPainter3 painter(drawing);
  RecordingCanvas canvas(painter.width(), painter.height());
  painter.draw(canvas);
  return canvas;
}

double area(const std::vector<Pixel>& polygon) {
  double twice = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Pixel &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    twice += a.x * b.y - b.x * a.y;
  }
  return std::abs(twice) / 2;
}

TEST(MapPicture3, ArcsAreStraightOnTheCube) {
  const MapDrawing3 drawing = square(0.5, 1);
  const MapPainter3 painter(drawing);
  const RecordingCanvas canvas = drawn(drawing);
  const auto fills = canvas.calls(Mark::kStripe, Kind::kFill);
  ASSERT_GE(fills.size(), 1u);
  ASSERT_EQ(fills[0].points.size(), 4u);
  EXPECT_NEAR(fills[0].points[0].y, fills[0].points[1].y, 1e-9);
  EXPECT_NEAR(fills[0].points[1].x, fills[0].points[2].x, 1e-9);
  // Half the tangent of what is seen of the side of the cube.
  const Pixel middle = painter.on_cube({0, 1, 0}), corner = painter.on_cube(unit(1 - 1e-9, 1, 0));
  EXPECT_NEAR((fills[0].points[1].x - middle.x) / (corner.x - middle.x), 0.5, 1e-6);
}

TEST(MapPicture3, EqualSolidAnglesAreEqualAreasOnTheDiscs) {
  const MapDrawing3 drawing = square(1, 1);  // a sixth of the sphere, in front
  const MapPainter3 painter(drawing);
  const RecordingCanvas canvas = drawn(drawing);
  const auto fills = canvas.calls(Mark::kStripe, Kind::kFill);
  const Pixel middle = painter.on_disc({0, 1, 0}), rim = painter.on_disc(unit(1, 1e-12, 0));
  const double radius = std::hypot(rim.x - middle.x, rim.y - middle.y);
  // A disc is half the sphere, so that the square has a third of it.
  EXPECT_NEAR(area(fills.back().points) / (std::numbers::pi * radius * radius), 1.0 / 3, 1e-3);
}

TEST(MapPicture3, NothingLeavesThePicture) {
  MapDrawing3 drawing = square(1, 3);
  for (MapPiece3 piece : square(1, 3).pieces) {  // behind
    for (Direction3& at : piece.corners) at = {-at.x, -at.y, at.z};
    drawing.pieces.push_back(piece);
  }
  const RecordingCanvas canvas = drawn(drawing);
  for (const auto& call : canvas.calls())
    for (const Pixel& p : call.points) {
      EXPECT_GE(p.x, -1e-6);
      EXPECT_GE(p.y, -1e-6);
      EXPECT_LE(p.x, canvas.width() + 1e-6);
      EXPECT_LE(p.y, canvas.height() + 1e-6);
    }
}

TEST(MapPicture3, PiecesOfOneFaceHaveNoLineBetweenThem) {
  const auto length = [](const MapDrawing3& drawing) {
    double sum = 0;
    for (const auto& call : drawn(drawing).calls(Mark::kEdge, Kind::kStroke))
      sum += std::hypot(call.points[1].x - call.points[0].x, call.points[1].y - call.points[0].y);
    return sum;
  };
  const double whole = length(square(0.5, 1));
  EXPECT_GT(whole, 0);
  EXPECT_NEAR(length(square(0.5, 4)), whole, 0.01 * whole);
  // Two halves of which one reaches further up: the line between them begins where the other half ends.
  MapDrawing3 step = square(0.5, 2);
  step.pieces[1].corners[2] = unit(0.5, 1, 0.8);
  step.pieces[1].corners[3] = unit(0, 1, 0.8);
  EXPECT_GT(length(step), 1.1 * whole);
}

TEST(MapPicture3, PiecesOfOtherFacesHave) {
  MapDrawing3 two = square(0.5, 2);
  two.colours.push_back({0.2, 0.2, 0.9});
  two.pieces[1].face = 1;
  EXPECT_GT(drawn(two).count(Mark::kEdge), drawn(square(0.5, 2)).count(Mark::kEdge));
}

TEST(MapPicture3, RefusesAWidthOutOfRange) {
  MapDrawing3 drawing = square(0.5, 1);
  drawing.width = 10;
  EXPECT_THROW(map_picture_3(drawing, PictureFormat::kPng), UsageError);
}

TEST(MapPicture3, BecomesAFileOfEitherFormat) {
  EXPECT_THAT(map_picture_3(square(0.5, 2), PictureFormat::kPng), testing::StartsWith("\x89PNG"));
  EXPECT_THAT(map_picture_3(square(0.5, 2), PictureFormat::kSvg), testing::HasSubstr("<svg"));
}

}  // namespace
}  // namespace hottel::map_picture_test

#include <gmock/gmock.h>

#include <vector>

#include "tests/viewer/plane/drawn_scenes.h"
#include "viewer/picture/plane/solid_polygons.h"

namespace hottel::hatch_test {
namespace {

std::vector<RecordingCanvas::Call> hatch_of(const std::vector<Pixel>& outline) {
  RecordingCanvas canvas(200, 100);
  draw_hatch_2(canvas, outline, 10, 1, {0, 0, 0, 1});
  return canvas.calls();
}

TEST(DrawHatch2, LinesGoAcrossAPolygonInsideTheCanvas) {
  const auto lines = hatch_of({{20, 20}, {80, 20}, {80, 60}, {20, 60}});
  EXPECT_EQ(lines.size(), 10u);  // levels 45, 55, ..., 135
  for (const auto& line : lines)
    for (const Pixel& end : line.points) {
      EXPECT_GE(end.x, 20);
      EXPECT_LE(end.x, 80);
      EXPECT_GE(end.y, 20 - 1e-9);
      EXPECT_LE(end.y, 60 + 1e-9);
    }
}

TEST(DrawHatch2, OfALargePolygonOnlyWhatIsOnTheCanvas) {
  for (const double far : {1e3, 1e6, 1e12, 1e20}) {
    const auto lines = hatch_of({{-far, -far}, {far, -far}, {far, far}, {-far, far}});
    EXPECT_EQ(lines.size(), 32u) << far;  // levels -5, 5, ..., 305
    for (const auto& line : lines)
      for (const Pixel& end : line.points) EXPECT_TRUE(end.x >= -10 && end.x <= 210 && end.y >= -10 && end.y <= 110);
  }
  EXPECT_TRUE(hatch_of({{1e6, 0}, {2e6, 0}, {2e6, 1}}).empty());
  EXPECT_TRUE(hatch_of({}).empty());
}

}  // namespace
}  // namespace hottel::hatch_test

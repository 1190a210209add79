// Contours of several levels: blended fields, lines that do not tangle, one label a line.
#include "viewer/picture/contour_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "tests/viewer/pixel_fields.h"
#include "viewer/picture/recording_canvas.h"
#include "viewer/picture/smoothed_field.h"

namespace hottel::contour_set_test {
namespace {

using pixel_fields::field;

PixelField rough_field() {
  std::mt19937 random(5);
  return field(200, 150, [&](double x, double y) {
    return 0.02 * x + std::sin(x / 9) + std::cos(y / 7) + static_cast<double>(random() % 1000) / 700;
  });
}

double roughness(const PixelField& field) {
  double sum = 0;
  for (std::size_t k = 1; k < field.values.size(); ++k)
    if (k % field.width != 0) sum += std::fabs(field.values[k] - field.values[k - 1]);
  return sum;
}

TEST(SmoothedField2, BlendsWhatIsFine) {
  EXPECT_LT(roughness(smoothed_field(rough_field(), 4)), 0.2 * roughness(rough_field()));
  const PixelField slope = field(60, 40, [](double x, double y) { return 3 * x - y; });
  const PixelField same = smoothed_field(slope, 5);
  for (std::size_t k = 0; k < slope.values.size(); ++k) EXPECT_NEAR(same.values[k], slope.values[k], 1e-4);
}

TEST(SmoothedField2, DoesNotBlendThroughWalls) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  PixelField two = field(40, 40, [](double x, double y) { return x < y ? 0.0 : 1.0; });
  two.cut.assign(39 * 39, false);
  for (std::size_t y = 0; y < 39; ++y)
    for (std::size_t x = 0; x < 39; ++x) two.cut[y * 39 + x] = x <= y + 1 && y <= x + 1;  // a wall along the diagonal
  two.values[5 * 40 + 20] = nan;
  const PixelField after = smoothed_field(two, 4);
  for (std::size_t k = 0; k < two.values.size(); ++k)
    if (k == 5 * 40 + 20) {
      EXPECT_TRUE(std::isnan(after.values[k]));
    } else {
      EXPECT_EQ(after.values[k], two.values[k]) << k % 40 << ' ' << k / 40;
    }
}

bool do_cross(const Pixel& a, const Pixel& b, const Pixel& c, const Pixel& d) {
  const auto side = [](const Pixel& p, const Pixel& q, const Pixel& r) {
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  };
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

// The slow way: every segment against every other one.
TEST(ContourSet2, LinesDoNotCross) {
  std::vector<double> levels;
  for (double level = -1.9; level < 7; level += 0.03) levels.push_back(level);
  const std::vector<Contour> contours = contour_set(smoothed_field(rough_field(), 3), levels, 10);
  std::vector<std::pair<Pixel, Pixel>> segments;
  for (const Contour& contour : contours)
    for (std::size_t k = 1; k < contour.line.size(); ++k) segments.emplace_back(contour.line[k - 1], contour.line[k]);
  std::ranges::sort(segments, {}, [](const auto& s) { return std::min(s.first.x, s.second.x); });
  std::size_t compared = 0;
  for (std::size_t i = 0; i < segments.size(); ++i)
    for (std::size_t j = i + 1; j < segments.size(); ++j) {
      const auto& [a, b] = segments[i];
      const auto& [c, d] = segments[j];
      if (std::min(c.x, d.x) > std::max(a.x, b.x)) break;
      ++compared;
      EXPECT_FALSE(do_cross(a, b, c, d));
    }
  EXPECT_GT(compared, 10'000u);
}

TEST(ContourSet2, SpecksAreLeftOut) {
  const PixelField rough = smoothed_field(rough_field(), 1);
  const std::vector<double> levels{1, 2, 3};
  const auto all = contour_set(rough, levels, 0), some = contour_set(rough, levels, 25);
  EXPECT_GT(all.size(), some.size());
  for (const Contour& contour : some) {
    const auto [left, right] = std::ranges::minmax(contour.line, {}, &Pixel::x);
    const auto [top, bottom] = std::ranges::minmax(contour.line, {}, &Pixel::y);
    EXPECT_GE(std::hypot(right.x - left.x, bottom.y - top.y), 25);
  }
}

TEST(ContourSet2, EachLineHasOneLabelAndNoneCoversAnother) {
  // Two hills with rings around each.
  const PixelField hills = field(400, 200, [](double x, double y) {
    return std::min(std::hypot(x - 100, y - 100), std::hypot(x - 300, y - 100));
  });
  const std::vector<double> levels{40, 80};
  const std::vector<Contour> contours = contour_set(hills, levels, 10);
  ASSERT_EQ(contours.size(), 4u);
  std::vector<std::string> names;
  for (const Contour& contour : contours) names.push_back(std::to_string(static_cast<int>(contour.level)));
  RecordingCanvas canvas(500, 300);
  draw_contours(canvas, contours, names, hills, {50, 20}, 1);
  std::multiset<std::string> written;
  std::vector<RecordingCanvas::Call> boxes;
  for (const RecordingCanvas::Call& call : canvas.calls(Mark::kCurve)) {
    if (call.kind == RecordingCanvas::Kind::kText) written.insert(call.text);
    if (call.kind == RecordingCanvas::Kind::kFill) boxes.push_back(call);
  }
  EXPECT_EQ(written, (std::multiset<std::string>{"40", "40", "80", "80"}));
  ASSERT_EQ(boxes.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      const auto &a = boxes[i].points, &b = boxes[j].points;
      EXPECT_TRUE(a[2].x <= b[0].x || b[2].x <= a[0].x || a[2].y <= b[0].y || b[2].y <= a[0].y);
    }
}

}  // namespace
}  // namespace hottel::contour_set_test

// Plots of errors against time, counted and measured on a canvas that remembers.
#include "viewer/picture/log_plot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "viewer/picture/recording_canvas.h"

namespace hottel {
namespace {

using Kind = RecordingCanvas::Kind;

LogPlot plot_of(std::vector<LogPlotCurve> curves) {
  LogPlot plot;
  plot.x_title = "x";
  plot.y_title = "y";
  plot.curves = std::move(curves);
  return plot;
}

RecordingCanvas drawn(const LogPlot& plot) {
  RecordingCanvas canvas(plot.width, plot.height);
  LogPlotPainter(plot).draw(canvas);
  return canvas;
}

// Strokes of curves, discs and polygons of points (each has a halo beneath it).
std::size_t points(const RecordingCanvas& canvas) {
  return (canvas.calls(Mark::kPoint, Kind::kDisc).size() + canvas.calls(Mark::kPoint, Kind::kFill).size()) / 2;
}

TEST(LogPlot, PlacesPointsInProportionToTheirLogarithms) {
  const LogPlot plot = plot_of({{"a", {{1e-3, 1e-8}, {10, 1}}}});
  const LogPlotPainter painter(plot);
  const Pixel low = painter.at(1e-3, 1e-8), high = painter.at(10, 1), middle = painter.at(0.1, 1e-4);
  EXPECT_DOUBLE_EQ(middle.x, (low.x + high.x) / 2);
  EXPECT_DOUBLE_EQ(middle.y, (low.y + high.y) / 2);
  EXPECT_LT(low.x, high.x);
  EXPECT_GT(low.y, high.y);
  for (const double factor : {2.0, 5.0, 7.0})
    EXPECT_NEAR((painter.at(factor, 1).x - painter.at(1, 1).x) / (painter.at(10, 1).x - painter.at(1, 1).x),
                std::log10(factor), 1e-12);
}

TEST(LogPlot, JoinsThePointsOfACurveInTheirOrder) {
  const LogPlot plot = plot_of({{"a", {{1, 1}, {10, 0.1}, {100, 0.01}}}, {"b", {{1, 0.5}}}});
  const RecordingCanvas canvas = drawn(plot);
  EXPECT_EQ(canvas.count(Mark::kCurve), 2u);
  EXPECT_EQ(points(canvas), 4u);
  const auto strokes = canvas.calls(Mark::kCurve);
  EXPECT_EQ(strokes[0].points[1], strokes[1].points[0]);
  EXPECT_TRUE(canvas.wrote("a"));
  EXPECT_TRUE(canvas.wrote("b"));
}

TEST(LogPlot, LeavesOutWhatHasNoPlaceAndBreaksNoLine) {
  const double infinity = std::numeric_limits<double>::infinity();
  const LogPlot plot =
      plot_of({{"a", {{1, 1}, {2, infinity}, {3, std::nan("")}, {0, 1}, {-1, 1}, {4, -1}, {10, 0.1}}}});
  const RecordingCanvas canvas = drawn(plot);
  EXPECT_EQ(points(canvas), 2u);
  EXPECT_EQ(canvas.count(Mark::kCurve), 1u);
}

TEST(LogPlot, ShowsZeroOnALevelOfItsOwnBelowAllDecades) {
  LogPlot plot = plot_of({{"a", {{1, 1e-5}, {2, 0}}}});
  plot.zero_label = "exact";
  const LogPlotPainter painter(plot);
  EXPECT_GT(painter.at(1, 0).y, painter.at(1, 1e-5).y);
  EXPECT_TRUE(drawn(plot).wrote("exact"));
  plot.curves[0].points.pop_back();
  EXPECT_FALSE(drawn(plot).wrote("exact"));
}

TEST(LogPlot, StaysInsideThePicture) {
  std::vector<LogPlotCurve> curves;
  for (int k = 0; k < 40; ++k)
    curves.push_back({"a family with a name that is much too long for the room beside the plot " + std::to_string(k),
                      {{std::pow(10, -9 + k / 4.0), std::pow(10, -k), "a label"}, {1e6, k % 2 ? 0 : 1e9, "another"}}});
  LogPlot plot = plot_of(curves);
  plot.title = std::string(300, 'w');
  plot.emphasised = 3;
  const RecordingCanvas canvas = drawn(plot);
  for (const auto& call : canvas.calls())
    for (const Pixel& p : call.points) {
      EXPECT_GE(p.x, 0);
      EXPECT_LE(p.x, plot.width + 1e-9) << call.text;
      EXPECT_GE(p.y, 0);
      EXPECT_LE(p.y, plot.height + 1e-9) << call.text;
    }
}

TEST(LogPlot, PutsNoLabelOnAPointOrAnotherLabel) {
  std::vector<LogPlotPoint> crowd;
  for (int k = 0; k < 60; ++k) crowd.push_back({std::pow(10, k / 20.0), std::pow(10, -(k % 7) / 3.0), "label"});
  const RecordingCanvas canvas = drawn(plot_of({{"a", crowd}}));
  const auto labels = canvas.calls(Mark::kLabel);
  EXPECT_GT(labels.size(), 5u);
  for (std::size_t i = 0; i < labels.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto &a = labels[i].points, &b = labels[j].points;
      EXPECT_FALSE(a[0].x < b[1].x && b[0].x < a[1].x && a[0].y + 4 < b[1].y && b[0].y + 4 < a[1].y);
    }
}

TEST(LogPlot, WithoutPointsIsAnEmptyField) {
  const RecordingCanvas canvas = drawn(plot_of({}));
  EXPECT_EQ(points(canvas), 0u);
  EXPECT_GT(canvas.count(Mark::kAxis), 0u);
}

TEST(WorkPrecisionPlot, HasACurveAFamilyAndTheExactMethodInInk) {
  const std::vector<WorkCurve> curves = {{"gauss", {{"gauss:1", 1e-3, 0.1, 1}, {"gauss:2", 1e-2, 0.05, 2}}},
                                         {"exact", {{"exact", 2e-3, 0, 0}}}};
  const LogPlot plot = work_precision_plot(curves, "title", "subtitle");
  ASSERT_EQ(plot.curves.size(), 2u);
  EXPECT_EQ(plot.emphasised, 1);
  EXPECT_EQ(plot.curves[0].points[1].label, "2");
  EXPECT_EQ(plot.curves[1].points[0].label, "");
  const RecordingCanvas canvas = drawn(plot);
  EXPECT_TRUE(canvas.wrote("1 ms"));
  EXPECT_TRUE(canvas.wrote("10 ms"));
  EXPECT_TRUE(canvas.wrote("exact"));
}

}  // namespace
}  // namespace hottel

// Plots of errors against time, counted and measured on a canvas that remembers.
#include "viewer/picture/log_plot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "viewer/picture/comparison_plot.h"
#include "viewer/picture/recording_canvas.h"

namespace hottel::log_plot_test {
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

TEST(LogPlot, LeavesOutWhatHasNoPlaceAndDrawsNoLineAcrossIt) {
  const double infinity = std::numeric_limits<double>::infinity();
  const RecordingCanvas canvas = drawn(plot_of(
      {{"a", {{1, 1}, {2, 0.5}, {3, infinity}, {4, std::nan("")}, {0, 1}, {-1, 1}, {5, -1}, {8, 0.2}, {10, 0.1}}}}));
  EXPECT_EQ(points(canvas), 4u);
  EXPECT_EQ(canvas.calls(Mark::kCurve, Kind::kStroke).size(), 2u);
}

// Three points in a row, the middle one labelled, and a second curve through the place above it.
TEST(LogPlot, PutsNoLabelOnALineWhereThereIsAnotherPlace) {
  const LogPlot plot = plot_of({{"a", {{1, 0.03}, {10, 0.03, "8"}, {100, 0.03}}}, {"b", {{1, 0.032}, {100, 0.032}}}});
  const RecordingCanvas canvas = drawn(plot);
  const auto labels = canvas.calls(Mark::kLabel, Kind::kText);
  ASSERT_EQ(labels.size(), 1u);
  const LogPlotPainter painter(plot);
  EXPECT_GT(labels[0].points.at(0).y, painter.at(10, 0.03).y) << "below both";
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

TEST(LogPlot, DrawsALevelAllAcrossWhateverItsXIs) {
  LogPlot plot = plot_of({{"a", {{1, 0.1}, {100, 0.001}}}, {"file", {{std::nan(""), 0.01}}, true}});
  const RecordingCanvas canvas = drawn(plot);
  EXPECT_EQ(points(canvas), 2u + 1u);
  const LogPlotPainter painter(plot);
  double least = INFINITY, most = 0;
  for (const auto& call : canvas.calls(Mark::kCurve))
    if (call.points[0].y == call.points[1].y) {
      EXPECT_NEAR(call.points[0].y, painter.at(1, 0.01).y, 1e-9);
      least = std::min(least, call.points[0].x);
      most = std::max(most, call.points[1].x);
    }
  EXPECT_NEAR(least, painter.at(1, 1).x, 1e-9);
  EXPECT_NEAR(most, painter.at(100, 1).x, 22);
}

MethodResult result_of(const std::string& name, const std::string& family, double seconds, double error,
                       double parameter = 0) {
  MethodResult result;
  result.info.name = name;
  result.info.family = family;
  result.info.parameter = parameter;
  result.timing.median = seconds;
  result.errors.max = error;
  result.errors.rms = error / 2;
  return result;
}

std::vector<MethodResult> some_results() {
  std::vector<MethodResult> results = {
      result_of("gauss:1", "gauss", 1e-3, 0.1, 1), result_of("gauss:2", "gauss", 1e-2, 0.05, 2),
      result_of("exact", "exact", 2e-3, 0), result_of("file:a/own.csv", "own", std::nan(""), 0.03)};
  results[1].max_radiosity_error = 0.25;
  results[2].max_radiosity_error = INFINITY;
  return results;
}

TEST(ComparisonPlot, HasACurveAFamilyAndTheExactMethodInInk) {
  const LogPlot plot = comparison_plot(some_results(), {}, "title", "subtitle");
  ASSERT_EQ(plot.curves.size(), 3u);
  EXPECT_EQ(plot.emphasised, 1);
  EXPECT_EQ(plot.curves[0].points[1].label, "2");
  EXPECT_EQ(plot.curves[1].points[0].label, "");
  const RecordingCanvas canvas = drawn(plot);
  EXPECT_TRUE(canvas.wrote("1 ms"));
  EXPECT_TRUE(canvas.wrote("10 ms"));
  EXPECT_TRUE(canvas.wrote("exact"));
}

TEST(ComparisonPlot, LabelsTheParameterOfASinglePoint) {
  const LogPlot plot = comparison_plot(std::vector{result_of("rays:64", "rays", 1, 0.1, 64)}, {}, "", "");
  EXPECT_EQ(plot.curves.at(0).points.at(0).label, "64");
}

TEST(ComparisonPlot, MakesALevelOfWhatHasNoPlaceAlongX) {
  const LogPlot by_time = comparison_plot(some_results(), {}, "", "");
  EXPECT_EQ(by_time.curves[2].name, "own");
  EXPECT_TRUE(by_time.curves[2].is_level);
  EXPECT_FALSE(by_time.curves[1].is_level);
  const LogPlot by_parameter = comparison_plot(some_results(), {PlotX::kParameter, ErrorKind::kRmsFactor}, "", "");
  ASSERT_EQ(by_parameter.curves.size(), 3u);
  EXPECT_EQ(by_parameter.curves[0].points[1].x, 2);
  EXPECT_EQ(by_parameter.curves[0].points[1].y, 0.025);
  EXPECT_EQ(by_parameter.curves[0].points[1].label, "");
  EXPECT_TRUE(by_parameter.curves[1].is_level);
  EXPECT_EQ(by_parameter.emphasised, -1);
}

// LogPlotPainter (4): colours and lengths of strokes tell thirty curves apart.
TEST(LogPlot, TellsThirtyCurvesApart) {
  LogPlot plot;
  for (int k = 0; k < 30; ++k) plot.curves.push_back({"c" + std::to_string(k), {{1, 1.0 + k}, {10, 1.0 + k}}});
  const RecordingCanvas canvas = drawn(plot);
  std::set<std::array<double, 4>> looks;
  const LogPlotPainter painter(plot);
  for (int k = 0; k < 30; ++k) {
    const double y = painter.at(1, 1.0 + k).y;
    std::array<double, 4> look{};
    for (const auto& stroke : canvas.calls(Mark::kCurve))
      if (std::abs(stroke.points[0].y - y) < 1e-6)
        look = {stroke.colour.r, stroke.colour.g, stroke.colour.b,
                std::max(look[3], std::round(stroke.points[1].x - stroke.points[0].x))};
    EXPECT_GT(look[3], 0) << k;
    looks.insert(look);
  }
  EXPECT_EQ(looks.size(), 30U);
}

// LogPlotPainter (6).
TEST(LogPlot, HasNoAxisWithoutAPlaceAlongIt) {
  LogPlot plot;
  plot.x_title = "time";
  plot.x_is_seconds = true;
  plot.curves.push_back({"file", {{NAN, 0.1}}, true});
  EXPECT_FALSE(drawn(plot).wrote("time"));
  EXPECT_FALSE(drawn(plot).wrote("1 s"));
  plot.curves.push_back({"exact", {{1, 0.1}}});
  EXPECT_TRUE(drawn(plot).wrote("time"));
}

TEST(ComparisonPlot, LeavesOutWhatHasNoSuchError) {
  const LogPlot plot = comparison_plot(some_results(), {PlotX::kTime, ErrorKind::kRadiosity}, "", "");
  ASSERT_EQ(plot.curves.size(), 1u);
  ASSERT_EQ(plot.curves[0].points.size(), 1u);
  EXPECT_EQ(plot.curves[0].points[0].y, 0.25);
}

}  // namespace
}  // namespace hottel::log_plot_test

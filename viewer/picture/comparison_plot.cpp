#include "viewer/picture/comparison_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/compare/work_precision.h"

namespace hottel {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double along_x(const MethodResult& result, PlotX x) {
  if (x == PlotX::kTime) return result.timing.median;
  if (x == PlotX::kElements) return static_cast<double>(result.elements);
  return result.info.parameter > 0 ? result.info.parameter : kNone;
}

std::string title_of(PlotX x) {
  switch (x) {
    case PlotX::kTime:
      return "time of the factors, median";
    case PlotX::kParameter:
      return "rays, points or pixels of a face";
    case PlotX::kElements:
      break;
  }
  return "elements";
}

std::string title_of(ErrorKind y) {
  switch (y) {
    case ErrorKind::kMaxFactor:
      return "largest error of a view factor";
    case ErrorKind::kRmsFactor:
      return "root mean square error of the view factors";
    case ErrorKind::kFaceRadiosity:
      return "largest error of the mean radiosity of a face, of the largest one";
    case ErrorKind::kRadiosity:
      break;
  }
  return "largest error of a radiosity, of the largest radiosity";
}

}  // namespace

LogPlot comparison_plot(std::span<const MethodResult> results, PlotAxes axes, const std::string& title,
                        const std::string& subtitle) {
  LogPlot plot;
  plot.title = title;
  plot.subtitle = subtitle;
  plot.x_title = title_of(axes.x);
  plot.y_title = title_of(axes.y);
  plot.x_is_seconds = axes.x == PlotX::kTime;
  plot.zero_label = "exact";
  for (const MethodResult& result : results) {
    const double x = along_x(result, axes.x), y = error_of(result, axes.y);
    const bool is_level = std::isnan(x);
    auto curve = std::ranges::find_if(plot.curves, [&](const LogPlotCurve& each) {
      return each.name == result.info.family && each.is_level == is_level;
    });
    if (!std::isfinite(y)) {  // no point, and none is joined across it
      if (!std::isnan(y) && curve != plot.curves.end()) curve->points.push_back({x, y, ""});
      continue;
    }
    if (curve == plot.curves.end()) {
      if (result.info.family == kExactFamily && !is_level) plot.emphasised = static_cast<int>(plot.curves.size());
      curve = plot.curves.insert(curve, LogPlotCurve{result.info.family, {}, is_level});
    }
    const bool is_labelled = axes.x == PlotX::kTime && result.info.parameter > 0;
    curve->points.push_back({x, y, is_labelled ? fmt::format("{:g}", result.info.parameter) : ""});
  }
  return plot;
}

}  // namespace hottel

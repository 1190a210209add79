#include "viewer/picture/work_precision_plot.h"

#include <fmt/format.h>

namespace hottel {

LogPlot work_precision_plot(std::span<const WorkCurve> curves, const std::string& title, const std::string& subtitle) {
  LogPlot plot;
  plot.title = title;
  plot.subtitle = subtitle;
  plot.x_title = "time of the factors, median";
  plot.y_title = "largest error of a view factor";
  plot.x_is_seconds = true;
  plot.zero_label = "exact";
  for (const WorkCurve& curve : curves) {
    if (curve.family == kExactFamily) plot.emphasised = static_cast<int>(plot.curves.size());
    LogPlotCurve drawn{curve.family, {}};
    for (const WorkPoint& point : curve.points)
      drawn.points.push_back(
          {point.seconds, point.error,
           curve.points.size() > 1 && point.parameter > 0 ? fmt::format("{:g}", point.parameter) : ""});
    plot.curves.push_back(std::move(drawn));
  }
  return plot;
}

}  // namespace hottel

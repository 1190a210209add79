// What accuracy costs: methods that were compared, as a plot.
#pragma once

#include <span>
#include <string>

#include "solver/compare/method_result.h"
#include "viewer/picture/log_plot.h"

namespace hottel {

// What stands along the axes. kParameter: rays, points or pixels (MethodInfo::parameter); kElements: of MethodResult.
enum class PlotX : unsigned char { kTime, kParameter, kElements };

struct PlotAxes {
  PlotX x = PlotX::kTime;
  ErrorKind y = ErrorKind::kMaxFactor;
};

// A curve a family, in the order in which families first appear, of its results in their order.
//
//   (1) a point with a parameter is labelled by it, unless x is the parameter or the elements
//   (2) results that have no place along x (a file has no time, `strings` no parameter) are a level across the plot, in
//       a curve of their own
//   (3) results without the error asked for, or with an infinite one, are left out; a family with none of any is no
//       curve
//   (4) along time the exact method, in ink, is a line down to its error: 0, on a level of its own
LogPlot comparison_plot(std::span<const MethodResult> results, PlotAxes axes, const std::string& title,
                        const std::string& subtitle);

}  // namespace hottel

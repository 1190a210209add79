// What accuracy costs, as a plot: time against error, one curve a family of methods.
#pragma once

#include <span>
#include <string>

#include "solver/compare/work_precision.h"
#include "viewer/picture/log_plot.h"

namespace hottel {

// Seconds along x, the largest error of a view factor along y, points labelled by their parameter. The
// exact method, in ink, is a line down to its error: 0, on a level of its own.
LogPlot work_precision_plot(std::span<const WorkCurve> curves, const std::string& title, const std::string& subtitle);

}  // namespace hottel

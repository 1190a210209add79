// Curves over two logarithmic axes.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "viewer/picture/cairo_canvas.h"
#include "viewer/picture/canvas.h"

namespace hottel {

// A pair of values, both in the unit of its axis.
struct LogPlotPoint {
  double x = 0, y = 0;
  std::string label{};  // small, beside the point where there is room; may be empty
};

// A line of the plot: points joined in their order.
struct LogPlotCurve {
  std::string name;  // for the legend
  std::vector<LogPlotPoint> points;
  bool is_level = false;  // values y without any x: each a broken line all across
};

// A plot as data: what stands on it, without where.
struct LogPlot {
  std::uint32_t width = 1600, height = 1000;
  std::string title{}, subtitle{};  // may be empty
  std::string x_title{}, y_title{};
  bool x_is_seconds = false;  // numbers along x are durations: 1 ms instead of 10⁻³
  std::vector<LogPlotCurve> curves{};
  std::string zero_label = "0";  // of the level of values that are 0
  // The curve that is drawn in ink and on top; where x are durations with a dashed line through each point.
  int emphasised = -1;
};

// Draws a plot with a legend at its right.
//
//   (1) a point at 10^a, 10^b lies in proportion to a and b; axes begin and end at whole decades
//   (2) values that are 0 lie on a level of their own below the lowest decade, named zero_label, apart by a dashed line
//   (3) points that are not finite, or not positive along x, are left out, and no line goes across them; a level has
//       no x
//   (4) the points of a curve are joined in their order; no two of the first 30 curves have the same colour and stroke
//       (10 colours; unbroken, dashed, dotted), and each has one of 6 markers. Levels are broken lines: long, dashed,
//       dotted
//   (5) nothing leaves the picture
//   (6) where no curve has a place along x there is no axis of it
// Degenerate: without points the axes span one decade.
// Throws UsageError for sides out of range (CairoCanvas).
class LogPlotPainter {
 public:
  // Decides where everything lies. REQUIRES that the plot outlives this, and that `emphasised` is below
  // the number of curves.
  explicit LogPlotPainter(const LogPlot& plot);

  // Draws on a canvas of the plot's size: paper, heading, axes, curves, labels where there is room, legend.
  void draw(PictureCanvas& canvas) const;
  // REQUIRES values that the plot shows: finite, x > 0, y >= 0.
  Pixel at(double x, double y) const;  // where a value is drawn

 private:
  struct Axis {
    int first = 0, last = 1;  // decades
    bool has_zero = false;    // a level one decade below `first`
    double position(double value) const;
  };
  static Axis axis_over(const std::vector<double>& values);

  void draw_axes(PictureCanvas& canvas) const;
  void draw_heading(PictureCanvas& canvas) const;
  void draw_curve(PictureCanvas& canvas, std::size_t k) const;
  void draw_labels(PictureCanvas& canvas) const;
  void draw_legend(PictureCanvas& canvas) const;
  void draw_marker(PictureCanvas& canvas, std::size_t curve, Pixel centre, Mark mark) const;
  std::vector<LogPlotPoint> shown(const LogPlotCurve& curve) const;
  std::vector<std::array<Pixel, 2>> lines(const LogPlotCurve& curve) const;
  Colour colour(std::size_t curve) const;
  std::size_t place_among_coloured(std::size_t curve) const;
  void draw_line(PictureCanvas& canvas, std::size_t curve, Pixel from, Pixel to, Mark mark) const;
  void draw_x_axis(PictureCanvas& canvas) const;

  const LogPlot& plot_;
  double unit_;
  Pixel top_left_, bottom_right_;  // of the field inside the axes
  bool has_x_ = false;             // some curve has a place along x
  Axis x_, y_;
};

// Returns the bytes of the picture file. Throws UsageError for sides out of range. The same plot gives the same
// bytes on one machine.
std::string log_plot(const LogPlot& plot, PictureFormat format);

}  // namespace hottel

#include "viewer/picture/log_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "kernel/plain_functions.h"
#include "viewer/picture/palette.h"

namespace hottel {
namespace {

constexpr double kLegendWidth = 330, kLegendLine = 34;

// A line in parts, in the plot's units.
struct Broken {
  double drawn, left_out;
};
constexpr std::array<Broken, 2> kBroken{{{10, 8}, {1, 6}}};
constexpr std::array<Broken, 3> kLevels{{{26, 9}, {10, 8}, {1, 6}}};

// "10⁻³"
std::string power_of_ten(int exponent) {
  static constexpr const char* kRaised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  if (exponent == 0) return "1";
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent))) text += kRaised[digit - '0'];
  return text;
}

// "10 µs"
std::string duration(int exponent) {
  if (exponent < -9 || exponent > 5) return power_of_ten(exponent) + " s";
  static constexpr const char* kUnits[] = {"ns", "µs", "ms", "s"};
  const int unit = std::min((exponent + 9) / 3, 3);
  return fmt::format("{:.0f} {}", same_bits::pow(10, exponent + 9 - 3 * unit), kUnits[unit]);
}

bool overlap(const std::array<Pixel, 2>& a, const std::array<Pixel, 2>& b) {
  return a[0].x < b[1].x && b[0].x < a[1].x && a[0].y < b[1].y && b[0].y < a[1].y;
}

std::array<Pixel, 2> box_about(Pixel centre, double half) {
  return {{{centre.x - half, centre.y - half}, {centre.x + half, centre.y + half}}};
}

// Whether a plot shows a point.
bool is_shown(const LogPlotPoint& point, bool is_level) {
  return std::isfinite(point.y) && point.y >= 0 && (is_level || (std::isfinite(point.x) && point.x > 0));
}

// Whether a line meets a box: what is left of it between the sides.
bool crosses(const std::array<Pixel, 2>& box, const std::array<Pixel, 2>& line) {
  double begin = 0, end = 1;
  const auto cut = [&](double from, double to, double low, double high) {
    if (from == to) return from >= low && from <= high;
    const double a = (low - from) / (to - from), b = (high - from) / (to - from);
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
    return begin <= end;
  };
  return cut(line[0].x, line[1].x, box[0].x, box[1].x) && cut(line[0].y, line[1].y, box[0].y, box[1].y);
}

}  // namespace

double LogPlotPainter::Axis::position(double value) const {
  const double lowest = first - (has_zero ? 1 : 0);
  const double exponent = value > 0 ? same_bits::log10(value) : lowest;
  return (exponent - lowest + (has_zero && value <= 0 ? 0.5 : 0.0)) / (last - lowest);
}

LogPlotPainter::Axis LogPlotPainter::axis_over(const std::vector<double>& values) {
  Axis axis;
  double least = INFINITY, greatest = 0;
  for (const double value : values) {
    if (value == 0) axis.has_zero = true;
    if (value > 0) least = std::min(least, value);
    if (value > 0) greatest = std::max(greatest, value);
  }
  if (greatest == 0) return axis;
  axis.first = static_cast<int>(std::floor(same_bits::log10(least)));
  axis.last = std::max(axis.first + 1, static_cast<int>(std::ceil(same_bits::log10(greatest))));
  return axis;
}

LogPlotPainter::LogPlotPainter(const LogPlot& plot) : plot_(plot), unit_(std::max(plot.width / 1600.0, 0.6)) {
  std::vector<double> x, y;
  for (const LogPlotCurve& curve : plot.curves)
    for (const LogPlotPoint& point : shown(curve)) {
      if (!curve.is_level) x.push_back(point.x);
      y.push_back(point.y);
    }
  has_x_ = !x.empty();
  x_ = axis_over(x);
  y_ = axis_over(y);
  const double heading = (plot.title.empty() ? 0 : 62) + (plot.subtitle.empty() ? 0 : 32);
  top_left_ = {120 * unit_, (70 + heading) * unit_};
  bottom_right_ = {plot.width - (kLegendWidth + 50) * unit_, plot.height - 96 * unit_};
}

// The lines between points that follow each other; none across one that is left out.
std::vector<std::array<Pixel, 2>> LogPlotPainter::lines(const LogPlotCurve& curve) const {
  std::vector<std::array<Pixel, 2>> result;
  if (curve.is_level) {
    for (const LogPlotPoint& point : shown(curve)) {
      const double y = at(1, point.y).y;
      result.push_back({Pixel{top_left_.x, y}, Pixel{bottom_right_.x, y}});
    }
    return result;
  }
  for (std::size_t p = 1; p < curve.points.size(); ++p) {
    const LogPlotPoint &from = curve.points[p - 1], &to = curve.points[p];
    if (is_shown(from, false) && is_shown(to, false)) result.push_back({at(from.x, from.y), at(to.x, to.y)});
  }
  return result;
}

std::vector<LogPlotPoint> LogPlotPainter::shown(const LogPlotCurve& curve) const {
  std::vector<LogPlotPoint> points;
  for (const LogPlotPoint& point : curve.points)
    if (is_shown(point, curve.is_level)) points.push_back(point);
  return points;
}

Pixel LogPlotPainter::at(double x, double y) const {
  return {std::lerp(top_left_.x, bottom_right_.x, x_.position(x)),
          std::lerp(bottom_right_.y, top_left_.y, y_.position(y))};
}

Colour LogPlotPainter::colour(std::size_t curve) const {
  const auto emphasised = static_cast<std::size_t>(plot_.emphasised);
  if (plot_.emphasised >= 0 && curve == emphasised) return palette::kInk;
  return palette::kCurves[place_among_coloured(curve) % palette::kCurves.size()];
}

// Those in ink take no colour.
std::size_t LogPlotPainter::place_among_coloured(std::size_t curve) const {
  return plot_.emphasised >= 0 && curve > static_cast<std::size_t>(plot_.emphasised) ? curve - 1 : curve;
}

// Once all colours are taken the next ten curves are dashed, then dotted.
void LogPlotPainter::draw_line(PictureCanvas& canvas, std::size_t curve, Pixel from, Pixel to, Mark mark) const {
  const std::size_t round = place_among_coloured(curve) / palette::kCurves.size();
  const double width = 2.6 * unit_;
  if (!plot_.curves[curve].is_level && round == 0) {
    canvas.stroke(mark, from, to, colour(curve), width);
    return;
  }
  // Levels are broken, whatever their round: else they would be taken for curves.
  const Broken broken =
      plot_.curves[curve].is_level ? kLevels[round % kLevels.size()] : kBroken[(round - 1) % kBroken.size()];
  const double all = std::hypot(to.x - from.x, to.y - from.y);
  const auto at_length = [&](double t) {
    const double part = all > 0 ? std::min(t / all, 1.0) : 0;
    return Pixel{std::lerp(from.x, to.x, part), std::lerp(from.y, to.y, part)};
  };
  for (double t = 0; t < all; t += (broken.drawn + broken.left_out) * unit_)
    canvas.stroke(mark, at_length(t), at_length(t + broken.drawn * unit_), colour(curve), width);
}

void LogPlotPainter::draw(PictureCanvas& canvas) const {
  canvas.fill_rectangle(Mark::kPaper, {0, 0}, {double(plot_.width), double(plot_.height)}, palette::kPaper);
  draw_heading(canvas);
  draw_axes(canvas);
  for (std::size_t k = 0; k < plot_.curves.size(); ++k)
    if (static_cast<int>(k) != plot_.emphasised) draw_curve(canvas, k);
  if (plot_.emphasised >= 0) draw_curve(canvas, static_cast<std::size_t>(plot_.emphasised));
  draw_labels(canvas);
  draw_legend(canvas);
}

void LogPlotPainter::draw_heading(PictureCanvas& canvas) const {
  const auto line = [&](const std::string& text, double y, TextStyle style) {
    const double room = plot_.width - 2 * 40 * unit_, wide = canvas.text_width(text, style);
    if (wide > room) style.size *= room / wide;
    canvas.text(Mark::kTitle, {40 * unit_, y}, text, style);
  };
  if (!plot_.title.empty())
    line(plot_.title, 62 * unit_, {.size = 32 * unit_, .colour = palette::kInk, .weight = TextWeight::kBold});
  if (!plot_.subtitle.empty())
    line(plot_.subtitle, (plot_.title.empty() ? 40 : 96) * unit_, {.size = 19 * unit_, .colour = palette::kSoftInk});
}

// Decades, what they are called, and the title.
void LogPlotPainter::draw_x_axis(PictureCanvas& canvas) const {
  const Colour grid = palette::kHatch.with_alpha(0.75), fine = palette::kHatch.with_alpha(0.28);
  const auto vertical = [&](double x, const Colour& ink) {
    const double where = at(x, 1).x;
    canvas.stroke(Mark::kAxis, {where, top_left_.y}, {where, bottom_right_.y}, ink, unit_);
  };
  const int every = std::max(1, (x_.last - x_.first) / 8);
  for (int k = x_.first; k <= x_.last; ++k) {
    const double decade = same_bits::pow(10, k);
    vertical(decade, grid);
    for (int m = 2; k < x_.last && x_.last - x_.first <= 8 && m <= 9; ++m) vertical(m * decade, fine);
    if ((k - x_.first) % every != 0) continue;
    canvas.text(Mark::kAxis, {at(decade, 1).x, bottom_right_.y + 27 * unit_},
                plot_.x_is_seconds ? duration(k) : power_of_ten(k),
                {.size = 17 * unit_, .colour = palette::kSoftInk, .anchor = TextAnchor::kCentre});
  }
  canvas.text(Mark::kAxis, {bottom_right_.x, bottom_right_.y + 64 * unit_}, plot_.x_title,
              {.size = 20 * unit_, .colour = palette::kInk, .anchor = TextAnchor::kRight});
}

void LogPlotPainter::draw_axes(PictureCanvas& canvas) const {
  const Colour grid = palette::kHatch.with_alpha(0.75);
  const TextStyle small{.size = 17 * unit_, .colour = palette::kSoftInk, .anchor = TextAnchor::kCentre};
  const auto horizontal = [&](double y, const Colour& ink) {
    const double where = at(1, y).y;
    canvas.stroke(Mark::kAxis, {top_left_.x, where}, {bottom_right_.x, where}, ink, unit_);
  };
  if (has_x_) draw_x_axis(canvas);
  const int y_every = std::max(1, (y_.last - y_.first + 6) / 12);
  TextStyle left = small;
  left.anchor = TextAnchor::kRight;
  for (int k = y_.first; k <= y_.last; ++k) {
    const double decade = same_bits::pow(10, k);
    horizontal(decade, grid);
    if ((y_.last - k) % y_every == 0)
      canvas.text(Mark::kAxis, {top_left_.x - 12 * unit_, at(1, decade).y + 6 * unit_}, power_of_ten(k), left);
  }
  if (y_.has_zero) {
    canvas.text(Mark::kAxis, {top_left_.x - 12 * unit_, at(1, 0).y + 6 * unit_}, plot_.zero_label, left);
    const double where = at(1, same_bits::pow(10, y_.first)).y;
    for (double x = top_left_.x; x < bottom_right_.x; x += 14 * unit_)
      canvas.stroke(Mark::kAxis, {x, where}, {std::min(x + 6 * unit_, bottom_right_.x), where}, palette::kSoftInk,
                    1.4 * unit_);
  }
  const Pixel corner{top_left_.x, bottom_right_.y};
  canvas.stroke(Mark::kAxis, corner, bottom_right_, palette::kInk, 1.8 * unit_);
  canvas.stroke(Mark::kAxis, corner, top_left_, palette::kInk, 1.8 * unit_);
  const TextStyle title{.size = 20 * unit_, .colour = palette::kInk};
  canvas.text(Mark::kAxis, {40 * unit_, top_left_.y - 18 * unit_}, plot_.y_title, title);
}

void LogPlotPainter::draw_marker(PictureCanvas& canvas, std::size_t curve, Pixel centre, Mark mark) const {
  const double r = (static_cast<int>(curve) == plot_.emphasised ? 10 : 7.5) * unit_;
  const auto polygon = [&](double radius) -> std::vector<Pixel> {
    const auto [x, y] = centre;
    switch (curve % 6) {
      case 1:
        return {{x - radius, y - radius}, {x + radius, y - radius}, {x + radius, y + radius}, {x - radius, y + radius}};
      case 2:
        return {{x, y - 1.35 * radius}, {x + 1.35 * radius, y}, {x, y + 1.35 * radius}, {x - 1.35 * radius, y}};
      case 3:
        return {{x, y - 1.25 * radius}, {x + 1.2 * radius, y + 0.85 * radius}, {x - 1.2 * radius, y + 0.85 * radius}};
      case 4:
        return {{x, y + 1.25 * radius}, {x - 1.2 * radius, y - 0.85 * radius}, {x + 1.2 * radius, y - 0.85 * radius}};
      default:
        return {};
    }
  };
  const double halo = r + 2.2 * unit_;
  const std::vector<Pixel> outer = polygon(0.9 * halo), inner = polygon(0.9 * r);
  if (inner.empty()) {
    canvas.disc(mark, centre, halo, palette::kPaper);
    canvas.disc(mark, centre, r, colour(curve));
    if (curve % 6 == 5) canvas.disc(mark, centre, 0.5 * r, palette::kPaper);
  } else {
    canvas.fill(mark, outer, palette::kPaper);
    canvas.fill(mark, inner, colour(curve));
  }
}

void LogPlotPainter::draw_curve(PictureCanvas& canvas, std::size_t k) const {
  const std::vector<LogPlotPoint> points = shown(plot_.curves[k]);
  if (plot_.curves[k].is_level) {
    for (const LogPlotPoint& point : points) {
      const double y = at(1, point.y).y;
      draw_line(canvas, k, {top_left_.x, y}, {bottom_right_.x, y}, Mark::kCurve);
      draw_marker(canvas, k, {bottom_right_.x, y}, Mark::kPoint);
    }
    return;
  }
  if (static_cast<int>(k) == plot_.emphasised && plot_.x_is_seconds)
    for (const LogPlotPoint& point : points) {
      const double x = at(point.x, point.y).x;
      for (double y = top_left_.y; y < bottom_right_.y; y += 16 * unit_)
        canvas.stroke(Mark::kCurve, {x, y}, {x, std::min(y + 8 * unit_, bottom_right_.y)}, palette::kInk, 1.8 * unit_);
    }
  for (const auto& [from, to] : lines(plot_.curves[k])) draw_line(canvas, k, from, to, Mark::kCurve);
  for (const LogPlotPoint& point : points) draw_marker(canvas, k, at(point.x, point.y), Mark::kPoint);
}

// Each label about its point, where it first meets nothing that is there already: no line where that can be.
void LogPlotPainter::draw_labels(PictureCanvas& canvas) const {
  std::vector<std::array<Pixel, 2>> taken, strokes;
  for (const LogPlotCurve& curve : plot_.curves) {
    for (const LogPlotPoint& point : shown(curve))
      if (!curve.is_level) taken.push_back(box_about(at(point.x, point.y), 8 * unit_));
    const auto of_curve = lines(curve);
    strokes.insert(strokes.end(), of_curve.begin(), of_curve.end());
  }
  for (std::size_t k = 0; k < plot_.curves.size(); ++k)
    for (const LogPlotPoint& point : shown(plot_.curves[k])) {
      if (point.label.empty() || plot_.curves[k].is_level) continue;
      const TextStyle style{.size = 14 * unit_, .colour = colour(k)};
      const double wide = canvas.text_width(point.label, style), high = 14 * unit_, gap = 12 * unit_;
      const auto [x, y] = at(point.x, point.y);
      const double left = x - gap - wide, right = x + gap, above = y - gap - high, below = y + gap;
      std::optional<std::array<Pixel, 2>> best;
      bool is_best_clear = false;
      for (const Pixel corner : {Pixel{x - wide / 2, above}, Pixel{x - wide / 2, below}, Pixel{right, y - high / 2},
                                 Pixel{left, y - high / 2}, Pixel{right, above}, Pixel{left, above},
                                 Pixel{right, below}, Pixel{left, below}}) {
        const std::array<Pixel, 2> box{{corner, {corner.x + wide, corner.y + high}}};
        const bool is_inside = box[0].x > top_left_.x && box[1].x < bottom_right_.x && box[0].y > top_left_.y &&
                               box[1].y < bottom_right_.y;
        if (!is_inside || std::any_of(taken.begin(), taken.end(), [&](const auto& b) { return overlap(box, b); }))
          continue;
        const bool is_clear =
            std::none_of(strokes.begin(), strokes.end(), [&](const auto& line) { return crosses(box, line); });
        if (best && (is_best_clear || !is_clear)) continue;
        best = box;
        is_best_clear = is_clear;
      }
      if (!best) continue;
      canvas.text(Mark::kLabel, {(*best)[0].x, (*best)[0].y + 0.85 * high}, point.label, style);
      taken.push_back(*best);
    }
}

void LogPlotPainter::draw_legend(PictureCanvas& canvas) const {
  const double left = bottom_right_.x + 36 * unit_, room = kLegendWidth * unit_ - 60 * unit_;
  const auto count = static_cast<double>(std::max<std::size_t>(plot_.curves.size(), 1));
  const double line = std::min(kLegendLine * unit_, (bottom_right_.y - top_left_.y) / count);
  for (std::size_t k = 0; k < plot_.curves.size(); ++k) {
    const double y = top_left_.y + (static_cast<double>(k) + 0.5) * line;
    if (plot_.curves[k].points.size() > 1 || plot_.curves[k].is_level)
      draw_line(canvas, k, {left, y}, {left + 40 * unit_, y}, Mark::kLegend);
    draw_marker(canvas, k, {left + 20 * unit_, y}, Mark::kLegend);
    TextStyle style{.size = std::min(18 * unit_, 0.7 * line), .colour = palette::kInk};
    const double wide = canvas.text_width(plot_.curves[k].name, style);
    if (wide > room) style.size *= room / wide;
    canvas.text(Mark::kLegend, {left + 54 * unit_, y + 0.35 * style.size}, plot_.curves[k].name, style);
  }
}

std::string log_plot(const LogPlot& plot, PictureFormat format) {
  CairoCanvas canvas(format, plot.width, plot.height);
  LogPlotPainter(plot).draw(canvas);
  return canvas.finish();
}

}  // namespace hottel

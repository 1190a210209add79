#include "viewer/picture/plane/visibility_painter.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "io/results/plane/visibility_report.h"
#include "kernel/plain_functions.h"
#include "kernel/support/failure.h"
#include "viewer/picture/cairo_canvas.h"
#include "viewer/picture/palette.h"

namespace hottel {
namespace {

constexpr double kFooterOfSights = 44;
constexpr double kFar = 1e4;  // times as far as anything that is seen

struct Rectangle {
  Pixel low, high;

  // Takes away the rounding of an intersection.
  Pixel nearest(const Pixel& p) const { return {std::clamp(p.x, low.x, high.x), std::clamp(p.y, low.y, high.y)}; }
};

// The picture without a border of that many units, so that lines and circles do not stick out of it.
Rectangle paper(const SceneSheet2& sheet, double border) {
  const double gap = border * sheet.unit();
  return {{gap, gap}, {sheet.width() - gap, sheet.height() - gap}};
}

// The part of a polygon in the rectangle (Sutherland and Hodgman, one border after the other).
std::vector<Pixel> clipped(std::vector<Pixel> polygon, const Rectangle& box) {
  const auto cut = [&polygon](auto depth) {  // depth(p) >= 0: p is inside
    std::vector<Pixel> kept;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Pixel &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
      const double at_p = depth(p), at_q = depth(q);
      if (at_p >= 0) kept.push_back(p);
      if ((at_p < 0) != (at_q < 0)) {
        const double t = at_p / (at_p - at_q);
        kept.push_back({std::lerp(p.x, q.x, t), std::lerp(p.y, q.y, t)});
      }
    }
    polygon = std::move(kept);
  };
  cut([&](const Pixel& p) { return p.x - box.low.x; });
  cut([&](const Pixel& p) { return box.high.x - p.x; });
  cut([&](const Pixel& p) { return p.y - box.low.y; });
  cut([&](const Pixel& p) { return box.high.y - p.y; });
  for (Pixel& p : polygon) p = box.nearest(p);
  return polygon;
}

// The part of a segment in the rectangle (Liang and Barsky).
std::optional<std::pair<Pixel, Pixel>> clipped(const Pixel& a, const Pixel& b, const Rectangle& box) {
  double enter = 0, leave = 1;
  const auto border = [&](double start, double step) {  // keeps t with start + t * step >= 0
    if (step == 0) return start >= 0;
    const double t = -start / step;
    (step > 0 ? enter : leave) = step > 0 ? std::max(enter, t) : std::min(leave, t);
    return enter <= leave;
  };
  if (!border(a.x - box.low.x, b.x - a.x) || !border(box.high.x - a.x, a.x - b.x) ||
      !border(a.y - box.low.y, b.y - a.y) || !border(box.high.y - a.y, a.y - b.y))
    return std::nullopt;
  const auto at = [&](double t) { return box.nearest({std::lerp(a.x, b.x, t), std::lerp(a.y, b.y, t)}); };
  return std::pair{at(enter), at(leave)};
}

void draw_line(PictureCanvas& canvas, const SceneSheet2& sheet, const std::array<double, 2>& from,
               const std::array<double, 2>& to) {
  const auto seen = clipped(sheet.frame().at(from), sheet.frame().at(to), paper(sheet, 1));
  if (seen) canvas.stroke(Mark::kRay, seen->first, seen->second, palette::kRay, 1.4 * sheet.unit());
}

void draw_ring(PictureCanvas& canvas, Mark mark, Pixel at, double radius, const Colour& inside, double line_width) {
  canvas.disc(mark, at, radius, inside);
  canvas.circle(mark, at, radius, palette::kInk, line_width);
}

// The angle from one direction counter-clockwise to another, above 0 and at most a whole turn; the side is exact.
double turn(const Point2& eye, const Point2& from, const Point2& to) {
  const Rational ax = from.x - eye.x, ay = from.y - eye.y, bx = to.x - eye.x, by = to.y - eye.y;
  const Rational cross = ax * by - ay * bx, dot = ax * bx + ay * by;
  const double angle = same_bits::atan2(std::abs(to_double(cross)), to_double(dot));
  return cross > 0 || (cross == 0 && dot < 0) ? angle : 2 * std::numbers::pi - angle;
}

// Adds points in so great a distance between two directions, near enough for straight lines between them to be far,
// too.
void add_sky(const Point2& eye, const Point2& from, const Point2& to, double distance,
             std::vector<std::array<double, 2>>& polygon) {
  const auto [x, y] = to_doubles(eye);
  const auto [from_x, from_y] = to_doubles(from);
  const double whole = turn(eye, from, to), begin = same_bits::atan2(from_y - y, from_x - x);
  const int steps = 1 + static_cast<int>(whole / (std::numbers::pi / 3));
  for (int k = 0; k <= steps; ++k) {
    const double angle = begin + whole * k / steps;
    polygon.push_back({x + distance * same_bits::cos(angle), y + distance * same_bits::sin(angle)});
  }
}

}  // namespace

VisibilityDrawing2 drawing_of(const VisibilityPolygon2& polygon) {
  VisibilityDrawing2 drawing;
  drawing.eye = to_doubles(polygon.eye);
  if (polygon.solid != Solids2::kNone) return drawing;
  double reach = 0;
  for (const auto& part : polygon.parts)
    for (const Point2* p : {&part.from, &part.to})
      reach = std::max(reach, std::hypot(to_doubles(*p)[0] - drawing.eye[0], to_doubles(*p)[1] - drawing.eye[1]));
  for (const auto& part : polygon.parts) {
    if (part.solid != Solids2::kNone) {
      drawing.polygon.push_back(drawing.eye);
      continue;
    }
    drawing.polygon.push_back(to_doubles(part.from));
    if (part.side == kSky && part.from != polygon.eye && part.to != polygon.eye)
      add_sky(polygon.eye, part.from, part.to, kFar * reach, drawing.polygon);
    drawing.polygon.push_back(to_doubles(part.to));
  }
  return drawing;
}

PairDrawing2 drawing_of(const PairSight2& sight) {
  PairDrawing2 drawing;
  drawing.a = sight.face_from ? *sight.face_from : *sight.face_to;
  drawing.b = sight.face_to ? *sight.face_to : *sight.face_from;
  drawing.a_label = sight.face_from ? sight.from : sight.to;
  drawing.b_label = sight.face_from && sight.face_to ? sight.to : "";
  for (const CriticalPoint2& c : sight.critical) {
    drawing.critical_on_a.push_back(to_doubles(c.point));
    drawing.lines.emplace_back(to_doubles(c.point), to_doubles(c.far));
  }
  return drawing;
}

VisibilityPainter2::VisibilityPainter2(const PreparedScene2& prepared, const VisibilityDrawing2& drawing)
    : VisibilityPainter2(drawing, SceneSheet2(prepared, drawing.sheet, kFooterOfSights, {drawing.eye})) {}

VisibilityPainter2::VisibilityPainter2(const VisibilityDrawing2& drawing, SceneSheet2 sheet)
    : drawing_(drawing), sheet_(std::move(sheet)) {}

void VisibilityPainter2::draw(PictureCanvas& canvas) const {
  sheet_.draw_ground(canvas, {});
  std::vector<Pixel> region;
  for (const auto& point : drawing_.polygon) region.push_back(sheet_.frame().at(point));
  region = clipped(std::move(region), paper(sheet_, 0));
  if (region.size() >= 3) canvas.fill(Mark::kLight, region, palette::kLight);
  for (const auto& point : drawing_.rays_to) draw_line(canvas, sheet_, drawing_.eye, point);
  sheet_.draw_walls(canvas);
  const double unit = sheet_.unit();
  for (const auto& point : drawing_.rays_to) {
    const Pixel at = sheet_.frame().at(point);
    if (clipped(at, at, paper(sheet_, 5)))
      draw_ring(canvas, Mark::kCritical, at, 3.6 * unit, palette::kPaper, 1.4 * unit);
  }
  const Pixel eye = sheet_.frame().at(drawing_.eye);
  canvas.disc(Mark::kEye, eye, 15 * unit, palette::kEmitter.with_alpha(0.45));
  draw_ring(canvas, Mark::kEye, eye, 7 * unit, palette::kEmitter, 2 * unit);
  sheet_.draw_footer_paper(canvas);
  sheet_.draw_scale_bar(canvas);
}

PairPainter2::PairPainter2(const PreparedScene2& prepared, const PairDrawing2& drawing)
    : PairPainter2(drawing, SceneSheet2(prepared, drawing.sheet, kFooterOfSights, drawing.critical_on_a)) {}

PairPainter2::PairPainter2(const PairDrawing2& drawing, SceneSheet2 sheet)
    : drawing_(drawing), sheet_(std::move(sheet)) {
  const std::size_t surfaces = sheet_.corners().surfaces();
  HOTTEL_REQUIRE(drawing_.a.surface < surfaces && drawing_.b.surface < surfaces);
}

void PairPainter2::draw(PictureCanvas& canvas) const {
  sheet_.draw_ground(canvas, {});
  for (const auto& [from, to] : drawing_.lines) draw_line(canvas, sheet_, from, to);
  std::vector<bool> highlighted(sheet_.corners().surfaces(), false);
  highlighted[drawing_.a.surface] = highlighted[drawing_.b.surface] = true;
  sheet_.draw_walls(canvas, highlighted);
  draw_edge(canvas, drawing_.b, drawing_.b_label, palette::kSecond);
  draw_edge(canvas, drawing_.a, drawing_.a_label, palette::kFirst);
  const double unit = sheet_.unit();
  for (const auto& point : drawing_.critical_on_a)
    draw_ring(canvas, Mark::kCritical, sheet_.frame().at(point), 6 * unit, palette::kPaper, 2 * unit);
  sheet_.draw_footer_paper(canvas);
  sheet_.draw_scale_bar(canvas);
}

void PairPainter2::draw_edge(PictureCanvas& canvas, const Face& face, const std::string& label,
                             const Colour& colour) const {
  const double unit = sheet_.unit();
  const Pixel from = sheet_.from(face.surface), to = sheet_.to(face.surface);
  canvas.stroke(Mark::kTarget, from, to, colour, std::max(2.4 * sheet_.wall_width(), 5 * unit));
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  if (length == 0) return;
  // Right of from -> to is the front; the label keeps clear of the line, however wide it is, and of the border.
  const TextStyle style{
      .size = 24 * unit, .colour = colour, .anchor = TextAnchor::kCentre, .weight = TextWeight::kBold};
  const double half = canvas.text_width(label, style) / 2, side = face.is_back ? -1 : 1;
  const double across_x = -side * (to.y - from.y) / length, across_y = side * (to.x - from.x) / length;
  const double away = 16 * unit + std::abs(across_x) * half + std::abs(across_y) * 9 * unit;
  const double x = (from.x + to.x) / 2 + away * across_x, y = (from.y + to.y) / 2 + away * across_y;
  canvas.text(
      Mark::kLabel,
      {std::clamp(x, std::min(half, sheet_.width() / 2.0), std::max(sheet_.width() - half, sheet_.width() / 2.0)),
       std::clamp(y + 9 * unit, 24 * unit, sheet_.height() - 8 * unit)},
      label, style);
}

std::string visibility_picture_2(const PreparedScene2& prepared, const VisibilityDrawing2& drawing,
                                 PictureFormat format) {
  const VisibilityPainter2 painter(prepared, drawing);
  CairoCanvas canvas(format, painter.width(), painter.height());
  painter.draw(canvas);
  return canvas.finish();
}

std::string pair_picture_2(const PreparedScene2& prepared, const PairDrawing2& drawing, PictureFormat format) {
  const PairPainter2 painter(prepared, drawing);
  CairoCanvas canvas(format, painter.width(), painter.height());
  painter.draw(canvas);
  return canvas.finish();
}

}  // namespace hottel

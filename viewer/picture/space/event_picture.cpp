#include "viewer/picture/space/event_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/space/scene/scene.h"
#include "viewer/picture/cairo_canvas.h"
#include "viewer/picture/palette.h"

namespace hottel {
namespace {

constexpr double kEventMargin = 24, kEventFooter = 44, kEventLine = 1.1;

using DrawnPoint = std::array<double, 3>;

double dot_of(const DrawnPoint& a, const DrawnPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

DrawnPoint length_one(const DrawnPoint& a) {
  const double size = std::sqrt(dot_of(a, a));
  return {a[0] / size, a[1] / size, a[2] / size};
}

Colour event_colour(EventSurface3::Kind kind) {
  return kind == EventSurface3::Kind::kEV ? palette::kFirst : palette::kSecond;
}

}  // namespace

EventPainter3::EventPainter3(const Scene3& scene, const Face& to, std::span<const EventSurface3> events, double width)
    : events_(events), width_(width) {
  const Polygon3& polygon = scene.polygons[to.surface];
  for (const Point3& corner : polygon.points) corners_.push_back(to_doubles(corner));
  Vector3 normal = doubled_area(polygon);
  if (to.is_back) normal = {-normal.x, -normal.y, -normal.z};
  const Vector3 side = polygon.points[1] - polygon.points[0];
  axes_ = {length_one(to_doubles(side)), length_one(to_doubles(cross(normal, side)))};
  for (std::size_t c = 0; c < 2; ++c) {
    const auto along = [&](const DrawnPoint& corner) { return dot_of(corner, axes_[c]); };
    low_[c] = along(*std::ranges::min_element(corners_, {}, along));
    high_[c] = along(*std::ranges::max_element(corners_, {}, along));
  }
  scale_ = (width_ - 2 * kEventMargin) / (high_[0] - low_[0]);
}

double EventPainter3::height() const {
  return std::ceil(scale_ * (high_[1] - low_[1]) + 2 * kEventMargin + kEventFooter);
}

Pixel EventPainter3::place(const DrawnPoint& p) const {
  return {kEventMargin + scale_ * (dot_of(p, axes_[0]) - low_[0]),
          kEventMargin + scale_ * (high_[1] - dot_of(p, axes_[1]))};
}

void EventPainter3::draw(PictureCanvas& canvas) const {
  canvas.fill_rectangle(Mark::kPaper, {0, 0}, {canvas.width(), canvas.height()}, palette::kPaper);
  std::vector<Pixel> outline;
  for (const DrawnPoint& corner : corners_) outline.push_back(place(corner));
  canvas.fill(Mark::kFloor, outline, palette::kFloor);
  draw_edges(canvas);
  draw_traces(canvas);
  for (std::size_t k = 0; k < outline.size(); ++k)
    canvas.stroke(Mark::kEdge, outline[k], outline[(k + 1) % outline.size()], palette::kInk, 1.5 * kEventLine);
  draw_legend(canvas);
}

void EventPainter3::draw_edges(PictureCanvas& canvas) const {
  const auto draw_edge = [&](const std::array<Point3, 2>& edge) {
    canvas.stroke(Mark::kSolid, place(to_doubles(edge[0])), place(to_doubles(edge[1])), palette::kHatch,
                  2 * kEventLine);
  };
  for (const EventSurface3& event : events_) {
    draw_edge(event.edge);
    for (const auto& other : event.others) draw_edge(other);
  }
}

void EventPainter3::draw_traces(PictureCanvas& canvas) const {
  for (const EventSurface3& event : events_)
    for (std::size_t k = 1; k < event.rulings.size(); ++k)
      canvas.stroke(Mark::kCurve, place(event.rulings[k - 1].on_to), place(event.rulings[k].on_to),
                    event_colour(event.kind), kEventLine);
}

void EventPainter3::draw_legend(PictureCanvas& canvas) const {
  double x = kEventMargin;
  const double y = height() - kEventFooter / 2 - 4;
  const TextStyle style{.size = 14, .colour = palette::kInk};
  for (const auto& [kind, text] : {std::pair(EventSurface3::Kind::kEV, "EV: through an edge and a vertex"),
                                   std::pair(EventSurface3::Kind::kEEE, "EEE: through three edges")}) {
    canvas.stroke(Mark::kLegend, {x, y}, {x + 28, y}, event_colour(kind), 3 * kEventLine);
    canvas.text(Mark::kLegend, {x + 36, y + 5}, text, style);
    x += 36 + canvas.text_width(text, style) + 32;
  }
}

std::string event_picture_3(const Scene3& scene, const Face& to, std::span<const EventSurface3> events,
                            PictureFormat format) {
  const EventPainter3 painter(scene, to, events);
  CairoCanvas canvas(format, static_cast<std::uint32_t>(painter.width()), static_cast<std::uint32_t>(painter.height()));
  painter.draw(canvas);
  return canvas.finish();
}

}  // namespace hottel

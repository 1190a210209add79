#include "viewer/window/viewer_texts.h"

#include <algorithm>

#include "viewer/window/panel.h"

namespace hottel {
namespace {

constexpr double kTextGap = 12, kHeadRoom = 52, kLeastRoom = 58;  // units
constexpr double kLeastSide = 260;                                // units that a text is wide, where the window is

}  // namespace

TextRoom draw_head_and_line(PictureCanvas& canvas, const std::string& head, const std::string& line, Scrolls& scrolls,
                            double unit) {
  const double gap = kTextGap * unit, width = canvas.width(), height = canvas.height();
  const double head_height = draw_panel(
      canvas, {.lines = {head}},
      {.corner = {gap, gap}, .width = 0.7 * width, .height = 0.3 * height, .scroll = &scrolls.of("head")}, unit);
  draw_panel(canvas, {.lines = {"h  help"}, .is_head_bold = false},
             {.corner = {width - gap, gap}, .is_right = true, .width = 200 * unit}, unit);
  TextRoom room{std::max(kHeadRoom * unit, 1.5 * gap + head_height), height - gap};
  if (line.empty()) return room;
  room.bottom -= gap / 2 + draw_panel(canvas, {.lines = {line}, .is_head_bold = false},
                                      {.corner = {gap, height - gap},
                                       .is_bottom = true,
                                       .width = 0.8 * width,
                                       .height = 0.3 * height,
                                       .scroll = &scrolls.of("line")},
                                      unit);
  return room;
}

double side_width(const PictureCanvas& canvas, double share, double unit) {
  const double width = canvas.width();
  return std::max(share * width, std::min(kLeastSide * unit, width - 2 * kTextGap * unit));
}

void draw_side_texts(PictureCanvas& canvas, std::span<const SideText> texts, double share, const TextRoom& room,
                     Scrolls& scrolls, double unit) {
  const double gap = kTextGap * unit;
  double top = room.top;
  auto left = static_cast<double>(std::ranges::count_if(texts, [](const SideText& t) { return !t.lines.empty(); }));
  for (const SideText& text : texts) {
    if (text.lines.empty()) continue;
    const double height = (room.bottom - top - (left - 1) * gap) / left;
    --left;
    top += gap + draw_panel(canvas, {.lines = text.lines},
                            {.corner = {canvas.width() - gap, top},
                             .is_right = true,
                             .width = side_width(canvas, share, unit),
                             .height = std::max(height, kLeastRoom * unit),
                             .scroll = &scrolls.of(text.name)},
                            unit);
  }
}

}  // namespace hottel

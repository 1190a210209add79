#include "viewer/window/help.h"

#include <algorithm>
#include <string_view>

#include "viewer/picture/palette.h"

namespace hottel {

void draw_help(PictureCanvas& canvas, std::span<const Command> commands, std::span<const Gesture> gestures,
               double whole_unit) {
  canvas.fill_rectangle(Mark::kPaper, {0, 0}, {canvas.width(), canvas.height()}, palette::kPaper.with_alpha(0.97));
  const double unit = std::min(whole_unit, std::min(canvas.width() / 1100, canvas.height() / 640));
  const TextStyle bold{.size = 15 * unit, .colour = palette::kInk, .weight = TextWeight::kBold};
  const TextStyle key{.size = 14 * unit, .colour = palette::kTarget, .weight = TextWeight::kBold};
  const TextStyle plain{.size = 14 * unit, .colour = palette::kInk};
  double x = 40 * unit, y = 40 * unit;
  const auto line = [&](std::string_view left, double indent, std::string_view right) {
    canvas.text(Mark::kLegend, {x, y}, left, key);
    canvas.text(Mark::kLegend, {x + indent * unit, y}, right, plain);
    y += 20 * unit;
  };
  std::string_view topic;
  for (const Command& command : commands) {
    if (command.help.empty()) continue;
    if (command.topic != topic) {
      topic = command.topic;
      const bool is_column = topic == "edit" || topic == "walk" || topic.starts_with("material");
      if (is_column) x += 350 * unit;
      y = is_column ? 40 * unit : y + (topic == "look" ? 0 : 16 * unit);
      canvas.text(Mark::kLegend, {x, y}, topic, bold);
      y += 24 * unit;
    }
    line(command.key, 100, command.help);
  }
  y += 16 * unit;
  canvas.text(Mark::kLegend, {x, y}, "mouse", bold);
  y += 24 * unit;
  for (const Gesture& gesture : gestures) {
    canvas.text(Mark::kLegend, {x, y}, gesture.gesture, key);
    canvas.text(Mark::kLegend, {x + 16 * unit, y + 17 * unit}, gesture.help, plain);
    y += 37 * unit;
  }
}

}  // namespace hottel

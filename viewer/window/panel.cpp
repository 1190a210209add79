#include "viewer/window/panel.h"

#include <algorithm>

#include "viewer/picture/palette.h"

namespace hottel {
namespace {

constexpr double kLetters = 14, kLine = 19, kPadding = 10;
constexpr std::string_view kIndent = "    ";
constexpr Colour kBox{0.992, 0.988, 0.980, 0.93}, kWarningBox{1.0, 0.93, 0.90, 0.96};
constexpr Colour kBorder{0.16, 0.17, 0.20, 0.35};

// The longest beginning of a text that is no wider than that, one character at least.
std::size_t fitting(const PictureCanvas& canvas, std::string_view text, const TextStyle& style, double width) {
  std::size_t low = 1, high = text.size();
  while (low < high) {
    const std::size_t middle = (low + high + 1) / 2;
    if (canvas.text_width(text.substr(0, middle), style) <= width)
      low = middle;
    else
      high = middle - 1;
  }
  while (low < text.size() && (static_cast<unsigned char>(text[low]) & 0xC0) == 0x80) ++low;  // whole characters
  return low;
}

}  // namespace

std::vector<std::string> wrapped(const PictureCanvas& canvas, const std::string& text, const TextStyle& style,
                                 double width) {
  std::vector<std::string> lines;
  std::string_view rest = text;
  while (!rest.empty() && canvas.text_width(rest, style) > width) {
    std::size_t end = fitting(canvas, rest, style, width);
    if (const std::size_t blank = rest.rfind(' ', end); blank != std::string_view::npos && blank > end / 2) end = blank;
    lines.emplace_back(rest.substr(0, end));
    rest.remove_prefix(end);
    rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
  }
  lines.emplace_back(rest);
  return lines;
}

double draw_panel(PictureCanvas& canvas, const Panel& panel, const PanelPlace& place, double unit) {
  if (panel.lines.empty()) return 0;
  const double padding = kPadding * unit, line_height = kLine * unit;
  const TextStyle regular{.size = kLetters * unit, .colour = palette::kInk};
  TextStyle bold = regular;
  bold.weight = TextWeight::kBold;
  const auto style = [&](bool is_head) { return is_head && panel.is_head_bold ? bold : regular; };

  const double indent = canvas.text_width(kIndent, regular);
  std::vector<std::pair<std::string, bool>> lines;
  for (std::size_t k = 0; k < panel.lines.size(); ++k) {
    const std::size_t first = lines.size();
    for (const std::string& line : wrapped(canvas, panel.lines[k], style(k == 0), place.width - 2 * padding - indent))
      lines.emplace_back(lines.size() > first ? std::string(kIndent) + line : line, k == 0);
  }
  const auto room = static_cast<std::size_t>(std::max(1.0, (place.height - 2 * padding) / line_height));
  if (lines.size() > room) {
    const std::size_t missing = lines.size() - room + 1;
    lines.resize(room);
    lines.back() = {"... and " + std::to_string(missing) + " lines more", false};
  }
  double wide = 0;
  for (const auto& [line, is_head] : lines) wide = std::max(wide, canvas.text_width(line, style(is_head)));
  const double width = wide + 2 * padding, height = static_cast<double>(lines.size()) * line_height + 2 * padding;
  const double left = place.is_right ? width : place.is_centred ? width / 2 : 0;
  const Pixel low{place.corner.x - left, place.is_bottom ? place.corner.y - height : place.corner.y};
  canvas.fill_rectangle(Mark::kLegend, low, {low.x + width, low.y + height}, panel.is_warning ? kWarningBox : kBox);
  const Pixel corners[] = {low, {low.x + width, low.y}, {low.x + width, low.y + height}, {low.x, low.y + height}};
  for (std::size_t k = 0; k < 4; ++k)
    canvas.stroke(Mark::kLegend, corners[k], corners[(k + 1) % 4], kBorder, std::max(1.0, unit));
  double base_line = low.y + padding + 0.78 * line_height;
  for (const auto& [line, is_head] : lines) {
    canvas.text(Mark::kLegend, {low.x + padding, base_line}, line, style(is_head));
    base_line += line_height;
  }
  return height;
}

}  // namespace hottel

#include "viewer/window/panel.h"

#include <algorithm>

#include "viewer/picture/palette.h"

namespace hottel {
namespace {

constexpr double kLetters = 14, kLine = 19, kPadding = 10, kBetween = 16;
constexpr Colour kBox{0.992, 0.988, 0.980, 0.93}, kWarningBox{1.0, 0.93, 0.90, 0.96};
constexpr Colour kBorder{0.16, 0.17, 0.20, 0.35}, kMarked{0.02, 0.62, 0.83, 0.35};

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

std::vector<std::string> parted(const std::string& line) {
  std::vector<std::string> cells{""};
  for (const char c : line) {
    if (c == '\t')
      cells.emplace_back();
    else
      cells.back() += c;
  }
  return cells;
}

// A line as it is drawn: texts, and how far from the left of the box each begins.
struct Line {
  std::vector<std::pair<double, std::string>> texts{};
  bool is_head = false, is_marked = false;
};

}  // namespace

std::vector<std::string> wrapped(const PictureCanvas& canvas, const std::string& text, const TextStyle& style,
                                 double width) {
  std::vector<std::string> lines;
  std::string_view rest = text;
  while (!rest.empty() && canvas.text_width(rest, style) > width) {
    std::size_t end = fitting(canvas, rest, style, width);
    // At the last blank that has something before it.
    if (const std::size_t blank = rest.rfind(' ', end);
        blank != std::string_view::npos && rest.find_first_not_of(' ') < blank)
      end = blank;
    lines.emplace_back(rest.substr(0, end));
    rest.remove_prefix(end);
    rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
  }
  if (!rest.empty() || lines.empty()) lines.emplace_back(rest);
  return lines;
}

namespace {

// Lines in columns, and where the columns begin.
struct Columns {
  std::vector<std::vector<std::string>> cells;
  std::vector<double> begin{0};
};

template <class Style>
Columns columns_of(const PictureCanvas& canvas, const std::vector<std::string>& lines, const Style& style,
                   double between) {
  Columns result;
  std::vector<double>& begin = result.begin;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    result.cells.push_back(parted(lines[k]));
    for (std::size_t column = 0; column + 1 < result.cells[k].size(); ++column) {
      if (begin.size() < column + 2) begin.push_back(begin[column]);
      const double end = begin[column] + canvas.text_width(result.cells[k][column], style(k == 0)) + between;
      const double more = end - begin[column + 1];
      for (std::size_t next = column + 1; more > 0 && next < begin.size(); ++next) begin[next] += more;
    }
  }
  return result;
}

// The same without columns, where there is no room for the last of them.
std::vector<std::string> without_columns(std::vector<std::string> lines) {
  for (std::string& line : lines) std::ranges::replace(line, '\t', ' ');
  return lines;
}

}  // namespace

double draw_panel(PictureCanvas& canvas, const Panel& panel, const PanelPlace& place, double unit) {
  if (panel.lines.empty()) return 0;
  const double padding = kPadding * unit, line_height = kLine * unit;
  const TextStyle regular{.size = kLetters * unit, .colour = palette::kInk};
  TextStyle bold = regular;
  bold.weight = TextWeight::kBold;
  const auto style = [&](bool is_head) { return is_head && panel.is_head_bold ? bold : regular; };

  Columns columns = columns_of(canvas, panel.lines, style, kBetween * unit);
  const double least = 8 * kLetters * unit;
  if (columns.begin.back() > 0 && columns.begin.back() + least > place.width - 2 * padding)
    columns = columns_of(canvas, without_columns(panel.lines), style, 0);
  const auto& [cells, begin] = columns;
  std::vector<Line> lines;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const double left = begin[cells[k].size() - 1];
    const double room = std::max(place.width - 2 * padding - left, least);
    std::vector<std::string> parts = wrapped(canvas, cells[k].back(), style(k == 0), room);
    for (std::size_t part = 0; part < parts.size(); ++part) {
      Line line{.is_head = k == 0, .is_marked = k == panel.marked};
      for (std::size_t column = 0; part == 0 && column + 1 < cells[k].size(); ++column)
        line.texts.emplace_back(begin[column], cells[k][column]);
      line.texts.emplace_back(left, std::move(parts[part]));
      lines.push_back(std::move(line));
    }
  }
  const auto room = static_cast<std::size_t>(std::max(1.0, (place.height - 2 * padding) / line_height));
  const std::size_t all = lines.size();
  if (all > room && place.scroll == nullptr) {
    const std::size_t missing = lines.size() - room + 1;
    lines.resize(room);
    lines.back() = {{{0, "... and " + std::to_string(missing) + " lines more"}}};
  }
  double wide = 0;
  for (const Line& line : lines)
    for (const auto& [left, text] : line.texts)
      wide = std::max(wide, left + canvas.text_width(text, style(line.is_head)));
  const double width = wide + 2 * padding;
  const double height = static_cast<double>(std::min(room, all)) * line_height + 2 * padding;
  const double left = place.is_right ? width : place.is_centred ? width / 2 : 0;
  const Pixel low{place.corner.x - left, place.is_bottom ? place.corner.y - height : place.corner.y};
  canvas.fill_rectangle(Mark::kLegend, low, {low.x + width, low.y + height}, panel.is_warning ? kWarningBox : kBox);
  const Pixel corners[] = {low, {low.x + width, low.y}, {low.x + width, low.y + height}, {low.x, low.y + height}};
  for (std::size_t k = 0; k < 4; ++k)
    canvas.stroke(Mark::kLegend, corners[k], corners[(k + 1) % 4], kBorder, std::max(1.0, unit));
  const Pixel high{low.x + width, low.y + height};
  const std::size_t first = place.scroll ? place.scroll->draw(all, room, low, high) : 0;
  double base_line = low.y + padding + 0.78 * line_height;
  for (std::size_t k = first; k < std::min(first + room, lines.size()); ++k) {
    for (const auto& [from, text] : lines[k].texts) {
      const Pixel at{low.x + padding + from, base_line};
      if (lines[k].is_marked)
        canvas.fill_rectangle(Mark::kLegend, {at.x, at.y - 0.78 * line_height},
                              {at.x + canvas.text_width(text, regular), at.y + 0.22 * line_height}, kMarked);
      canvas.text(Mark::kLegend, at, text, style(lines[k].is_head));
    }
    base_line += line_height;
  }
  if (place.scroll) draw_scroll_mark(canvas, *place.scroll, low, high, unit);
  return height;
}

}  // namespace hottel

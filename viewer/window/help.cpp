#include "viewer/window/help.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "viewer/picture/palette.h"
#include "viewer/window/panel.h"

namespace hottel {
namespace {

constexpr double kMargin = 28, kRow = 20, kAfterKeys = 14, kColumnGap = 32;  // units

// One row of the help: a heading, or keys and what they do; all empty: a gap.
struct HelpRow {
  std::string heading{}, keys{}, help{};
};

std::vector<HelpRow> rows_of(std::span<const Command> commands, std::span<const Gesture> gestures) {
  std::vector<HelpRow> rows;
  std::string_view topic;
  for (const Command& command : commands) {
    if (command.topic != topic) {
      if (!rows.empty()) rows.emplace_back();
      rows.push_back({.heading = std::string(command.topic)});
    }
    topic = command.topic;
    if (!command.help.empty())
      rows.push_back({.keys = std::string(command.key), .help = std::string(command.help)});
    else if (const Command* first = &*std::ranges::find(commands, command.name, &Command::name); !first->help.empty())
      rows.back().keys += "  " + std::string(command.key);
  }
  rows.emplace_back();
  rows.push_back({.heading = "mouse"});
  for (const Gesture& gesture : gestures) {
    rows.push_back({.keys = std::string(gesture.gesture)});
    rows.push_back({.help = std::string(gesture.help)});
  }
  return rows;
}

// How rows are set, in pixels.
struct HelpLayout {
  TextStyle bold, key, plain;
  double indent = 0, column = 0;  // of what keys do; from a column to the next
  std::size_t columns = 1, room = 1;
};

double across_of(const PictureCanvas& canvas, double unit) { return canvas.width() - 2 * kMargin * unit; }

HelpLayout layout_of(const PictureCanvas& canvas, const std::vector<HelpRow>& rows, double unit) {
  HelpLayout set{.bold{.size = 15 * unit, .colour = palette::kInk, .weight = TextWeight::kBold},
                 .key{.size = 14 * unit, .colour = palette::kTarget, .weight = TextWeight::kBold},
                 .plain{.size = 14 * unit, .colour = palette::kInk}};
  double wide = 0;
  for (const HelpRow& row : rows)
    if (!row.help.empty()) set.indent = std::max(set.indent, canvas.text_width(row.keys, set.key) + kAfterKeys * unit);
  for (const HelpRow& row : rows)
    wide = std::max({wide, set.indent + canvas.text_width(row.help, set.plain), canvas.text_width(row.keys, set.key)});
  set.column = wide + kColumnGap * unit;
  const double across = (across_of(canvas, unit) + kColumnGap * unit) / set.column;
  const double down = (canvas.height() - 2 * kMargin * unit) / (kRow * unit);
  set.columns = static_cast<std::size_t>(std::max(1.0, across));
  set.room = static_cast<std::size_t>(std::max(1.0, down));
  return set;
}

// Where a column is wider than the window: what keys do beneath them, in as many rows as it takes.
std::vector<HelpRow> stacked(const PictureCanvas& canvas, const std::vector<HelpRow>& rows, HelpLayout& set,
                             double unit) {
  set.indent = std::min(kAfterKeys * unit, 0.1 * across_of(canvas, unit));
  std::vector<HelpRow> result;
  for (const HelpRow& row : rows) {
    if (row.help.empty() || !row.keys.empty()) result.push_back({row.heading, row.keys, ""});
    if (!row.help.empty())
      for (std::string& line : wrapped(canvas, row.help, set.plain, across_of(canvas, unit) - set.indent))
        result.push_back({.help = std::move(line)});
  }
  return result;
}

// The rows of each column: as even as can be, no heading at the end of one, no gap at its beginning.
std::vector<std::span<const HelpRow>> columns_of(std::span<const HelpRow> rows, std::size_t count) {
  std::vector<std::span<const HelpRow>> columns;
  for (std::size_t left = count; left > 0 && !rows.empty(); --left) {
    std::size_t size = left == 1 ? rows.size() : (rows.size() + left - 1) / left;
    while (size < rows.size() && size > 1 && (!rows[size - 1].heading.empty() || rows[size].help.empty())) --size;
    columns.push_back(rows.first(size));
    rows = rows.subspan(size);
    if (!rows.empty() && rows[0].help.empty() && rows[0].heading.empty() && rows[0].keys.empty())
      rows = rows.subspan(1);
  }
  return columns;
}

void draw_row(PictureCanvas& canvas, const HelpRow& row, const HelpLayout& set, const Pixel& at) {
  if (!row.heading.empty()) return canvas.text(Mark::kLegend, at, row.heading, set.bold);
  if (!row.keys.empty()) canvas.text(Mark::kLegend, at, row.keys, set.key);
  if (!row.help.empty()) canvas.text(Mark::kLegend, {at.x + set.indent, at.y}, row.help, set.plain);
}

}  // namespace

void draw_help(PictureCanvas& canvas, std::span<const Command> commands, std::span<const Gesture> gestures,
               Scroll& scroll, double unit) {
  const Pixel high{canvas.width(), canvas.height()};
  canvas.fill_rectangle(Mark::kPaper, {0, 0}, high, palette::kPaper.with_alpha(0.97));
  std::vector<HelpRow> rows = rows_of(commands, gestures);
  HelpLayout set = layout_of(canvas, rows, unit);
  if (set.column - kColumnGap * unit > across_of(canvas, unit)) rows = stacked(canvas, rows, set, unit);
  const std::vector<std::span<const HelpRow>> columns = columns_of(rows, set.columns);
  const std::size_t all = std::ranges::max(columns, {}, [](const auto& c) { return c.size(); }).size();
  const std::size_t first = scroll.draw(all, set.room, {0, 0}, high);
  for (std::size_t c = 0; c < columns.size(); ++c)
    for (std::size_t k = first; k < std::min(first + set.room, columns[c].size()); ++k)
      draw_row(canvas, columns[c][k], set,
               {kMargin * unit + static_cast<double>(c) * set.column,
                (kMargin + (static_cast<double>(k - first) + 0.75) * kRow) * unit});
  draw_scroll_mark(canvas, scroll, {0, 0}, high, unit);
}

}  // namespace hottel

// Boxes of text over a drawing.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "viewer/picture/canvas.h"
#include "viewer/window/scroll.h"

namespace hottel {

// A box of lines of text. Tabs part a line into columns, which are as wide as the widest of them.
struct Panel {
  std::vector<std::string> lines;
  bool is_head_bold = true;  // the first line
  bool is_warning = false;
  std::size_t marked = kNoLine;  // a line whose text is marked, as what will be replaced

  static constexpr std::size_t kNoLine = static_cast<std::size_t>(-1);
};

// Where a box is put: the corner of it that stays, and the room there is.
struct PanelPlace {
  Pixel corner;
  bool is_right = false, is_bottom = false;  // which of its corners that is
  bool is_centred = false;                   // the corner is the middle of its upper side
  double width = 400, height = 400;          // at most
  Scroll* scroll = nullptr;                  // how far the lines are scrolled; null: they are not
};

// Draws the box. Lines that are too long go on in the next line, indented. Where there is no room for all, a mark at
// the right shows which part is seen of those that can be scrolled; of others the last one says how many are missing.
// unit: of sizes, in pixels. Returns the box's height; nothing is drawn for no lines.
double draw_panel(PictureCanvas& canvas, const Panel& panel, const PanelPlace& place, double unit);

// Returns the text cut into lines no wider than that, at blanks where there are some.
std::vector<std::string> wrapped(const PictureCanvas& canvas, const std::string& text, const TextStyle& style,
                                 double width);

}  // namespace hottel

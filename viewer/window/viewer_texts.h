// The texts around a drawing in a window: what is seen, what was done, and what is known, at the right.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "viewer/picture/canvas.h"
#include "viewer/window/scroll.h"

namespace hottel {

// From where to where, down the window, there is room for other texts.
struct TextRoom {
  double top = 0, bottom = 0;
};

// Draws what is seen at the top, how to get help, and the line at the bottom, which may be empty. unit: of sizes, in
// pixels.
TextRoom draw_head_and_line(PictureCanvas& canvas, const std::string& head, const std::string& line, Scrolls& scrolls,
                            double unit);

// A text, and the name of its scroll.
struct SideText {
  std::string name;
  std::vector<std::string> lines;
};

// Draws texts at the right below each other: each has its part of the room, and what those above it leave of theirs.
// share: of the window's width, as a rule at most.
void draw_side_texts(PictureCanvas& canvas, std::span<const SideText> texts, double share, const TextRoom& room,
                     Scrolls& scrolls, double unit);

// The width of a text beside a drawing: that share of the window, but not less than letters need.
double side_width(const PictureCanvas& canvas, double share, double unit);

}  // namespace hottel

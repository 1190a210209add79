// The help of a window: all keys, and what the mouse does.
#pragma once

#include <span>

#include "viewer/picture/canvas.h"
#include "viewer/window/commands.h"
#include "viewer/window/scroll.h"

namespace hottel {

// Draws over all of the canvas: in as many columns as there is room for, each command with all of its keys. Letters
// keep their size; what is too long is scrolled. unit: of sizes, in pixels.
void draw_help(PictureCanvas& canvas, std::span<const Command> commands, std::span<const Gesture> gestures,
               Scroll& scroll, double unit);

}  // namespace hottel

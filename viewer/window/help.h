// The help of a window: all keys, and what the mouse does.
#pragma once

#include <span>

#include "viewer/picture/canvas.h"
#include "viewer/window/commands.h"

namespace hottel {

// Draws over all of the canvas. The topics "edit" and "walk", and those that begin with "material", begin a
// column. unit: of
// sizes, in pixels; smaller where there is no room.
void draw_help(PictureCanvas& canvas, std::span<const Command> commands, std::span<const Gesture> gestures,
               double unit);

}  // namespace hottel

// What one can tell a window that looks at space.
#pragma once

#include <span>

#include "viewer/window/commands.h"

namespace hottel {

// As commands() and gestures() are for the plane.
std::span<const Command> commands_3();
std::span<const Gesture> gestures_3();

}  // namespace hottel

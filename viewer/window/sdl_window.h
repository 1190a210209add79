// A window on the screen.
#pragma once

#include <memory>
#include <string>

#include "viewer/window/window.h"

namespace hottel {

// Opens a window that the user can resize; size says how large it is in the units of the desktop, of which a pixel of a
// frame may be a part. The window manager may give it another size.
//
//   (1) of moves, and of kResize, that wait one after the other, next() gives the last
//   (2) x and y of an event are in pixels of a frame of size(), and lie outside of it while a button that went down in
//       the window is held outside
//   (3) keys with Ctrl or Alt held type no text; the right Alt is none, since it types letters on many keyboards
//   (4) no signal handler is installed, and Ctrl-C is the program's own
//
// Throws RequestError where there is no display, or no window could be had: what() says what was tried and what needs
// no display; and where there is no SDL, or the program was built without a window (HOTTEL_WINDOW). show() throws
// RequestError where the frame could not be shown, ContractViolation unless it has width * height pixels, and one at
// least. REQUIRES: one such window at a time in a process; a positive size.
std::unique_ptr<Window> open_window(const std::string& title, FrameSize size);

}  // namespace hottel

// Storms of events over a viewer: all that hands can do to a window, at random, faster than light is made.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace hottel::viewer_storm {

struct StormOptions {
  int dimension = 3;       // 2 or 3
  std::uint64_t seed = 1;  // the same events for the same seed
  std::uint64_t events = 1000;
  std::uint32_t elements = 1;  // in space: polygons are divided by it
  std::string scene{};         // a file; empty: a small room with lights and overlapping surfaces
  std::uint32_t most_width = 640, most_height = 400;  // of the window; one size in a few is smaller, down to 1 x 1
};

struct StormResult {
  std::uint64_t events = 0, frames = 0, edits = 0, problems = 0;  // problems: frames that said there was no light
  std::uint64_t sizes = 0, reads = 0, viewers = 0;                // viewers: begun anew, where one was told to quit
  std::uint64_t shapes = 0;                                       // that drags of what was picked have made
  std::uint64_t rests = 0;                                        // at which files were compared
  std::vector<std::string> failures{};                            // what broke, with the number of the event
};

// Hands events to a viewer without a screen, and checks these laws. The seed determines the events; where one
// depends on what the window shows, a question for one, on how far the light is by then.
//
//   (1) no event throws: that would end the window
//   (2) a frame has the size of the window
//   (3) at rest, every so often and at the end, the viewer's files are those of a fresh viewer with the same scene
// Writes files into a temporary folder alone. Stops at the first failure.
StormResult run_storm(const StormOptions& options);

}  // namespace hottel::viewer_storm

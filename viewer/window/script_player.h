// Plays scripts on a viewer.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/window/recording_window.h"
#include "viewer/window/script.h"
#include "viewer/window/viewer.h"

namespace hottel {

// Where the results of a script go.
struct ScriptOutputs {
  std::function<void(const std::string&)> print;  // a line of text
  std::function<void(const Raster&)> frame = {};  // each frame of a recording; empty: nothing is recorded
};

// Frames a second of a recording.
inline constexpr int kFramesPerSecond = 20;

// Does the steps, one after the other; ends early where the window is closed.
//
//   (1) after each step all that the viewer shows is waited for: a script does the same on every machine
//   (2) a recording has a frame for every event, and kFramesPerSecond for a second of "pause", in which what runs in
//       the background goes on as it does; lights that move are waited for, frame by frame
// REQUIRES: the viewer is that of the window. Throws InputError naming the line for what makes no sense, OutputError.
void play_script(const std::vector<ScriptStep>& steps, const std::string& name, Viewer& viewer, RecordingWindow& window,
                 const ScriptOutputs& outputs);

// Writes a frame as a PNG file. Throws UsageError unless the file ends in .png, OutputError.
void save_screenshot(const Raster& frame, const std::filesystem::path& file);

// Reads a number of an argument. False for what is none, or beyond 1e300.
bool read_script_number(std::string_view text, double& value);

}  // namespace hottel

// What a window does with its events, whatever it shows.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "kernel/rational.h"
#include "viewer/picture/canvas.h"
#include "viewer/window/script.h"
#include "viewer/window/window.h"

namespace hottel {

// A scene on a desk, as those see it who hand it events: the loop of a window, and scripts. Its functions are for the
// thread of the window.
class Desk {
 public:
  virtual ~Desk() = default;

  // Takes one event.
  virtual void handle(const WindowEvent& event) = 0;
  // Does what a key of that name does, at the mouse. Throws UsageError for other names.
  virtual void command(std::string_view name) = 0;
  // Takes what has come in the background, and draws and shows a frame where something has changed. Returns whether it
  // has.
  virtual bool update() = 0;
  // Waits until all that is shown is of the scene as it is now, and updates. Throws RequestError after so many seconds.
  virtual void settle(double seconds) = 0;
  virtual bool wants_quit() const = 0;
  // Lets so many seconds go by for lights that move. Returns whether any do.
  virtual bool pass_time(const Rational& seconds) = 0;

  // Writes what is seen without any text about it to a file that ends in .png, .svg or .pdf. Throws UsageError for
  // another ending, OutputError.
  virtual void save_picture(const std::filesystem::path& file) const = 0;
  // Writes the scene to another file, which is the scene's from now on. Throws as write_output_file does.
  virtual void save_as(const std::filesystem::path& file) = 0;

  // Where a place of the scene is seen. Throws UsageError where that is not as many numbers as the scene has
  // dimensions, or not in front of the eye.
  virtual Pixel pixel_of_place(std::span<const double> place) const = 0;
  // A line with the SHA-256 of each file that a fresh process would write of the scene as it is; "-" for each where
  // there is no light.
  virtual std::string hashes() const = 0;
  // Does a step of a script that only this kind of scene has. Returns false where it is none of those.
  virtual bool do_own_step(const ScriptStep& step) = 0;
};

// Takes events and updates until the desk wants to quit; at least so often, also where nothing happens, and fifty times
// a second while lights move. Their time goes by as that of the clock, in thousandths of a second.
void run_desk(Desk& desk, Window& window, double seconds);

}  // namespace hottel

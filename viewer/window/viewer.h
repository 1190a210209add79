// What a window does with its events, in the plane and in space.
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

// Shows a scene in a window and edits it, by the events that the loop of a window or a script hands to it. Its
// functions are for the thread of the window.
class Viewer {
 public:
  virtual ~Viewer() = default;

  // Takes one event.
  virtual void handle(const WindowEvent& event) = 0;
  // Does what a key of that name does, at the mouse. Throws UsageError for other names.
  virtual void command(std::string_view name) = 0;
  // Takes over results from the background; if something has changed, draws a frame and shows it. Returns whether it
  // did.
  virtual bool update() = 0;
  // Waits until everything shown belongs to the scene as it is now, and updates. Throws RequestError after so many
  // seconds.
  virtual void settle(double seconds) = 0;
  virtual bool wants_quit() const = 0;
  // Advances moving lights by so many seconds. Returns whether any move.
  virtual bool pass_time(const Rational& seconds) = 0;

  // Writes the picture, without the texts about it, to a file that ends in .png, .svg or .pdf. Throws UsageError for
  // another ending, OutputError.
  virtual void save_picture(const std::filesystem::path& file) const = 0;
  // Writes the scene to another file, which is the scene's from now on. Throws as write_output_file does.
  virtual void save_as(const std::filesystem::path& file) = 0;

  // The pixel at which a place of the scene is seen. Throws UsageError if the place has not as many numbers as the
  // scene has dimensions, or is not in front of the eye.
  virtual Pixel pixel_of_place(std::span<const double> place) const = 0;
  // A line with the SHA-256 of each file that a fresh process would write for the scene as it is; "-" for each if there
  // is no light.
  virtual std::string hashes() const = 0;
  // Does a step of a script that only scenes of this dimension have. Returns false for all other steps.
  virtual bool do_own_step(const ScriptStep& step) = 0;

  // Takes events and updates until it wants to quit: at least once a second even if nothing happens, and fifty times a
  // second while lights move. Their time follows the clock, in thousandths of a second.
  virtual void run() = 0;
};

}  // namespace hottel

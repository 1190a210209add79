// What a window does with its events whatever the dimension of its scene.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/light.h"
#include "geometry/scene_table.h"
#include "kernel/support/stopwatch.h"
#include "viewer/edit/light_hold.h"
#include "viewer/picture/raster.h"
#include "viewer/picture/tone_curve.h"
#include "viewer/window/commands.h"
#include "viewer/window/prompt.h"
#include "viewer/window/scroll.h"
#include "viewer/window/viewer.h"
#include "viewer/window/viewer_texts.h"
#include "viewer/window/watched_file.h"

namespace hottel {

// A viewer but for what is seen and edited: mouse and keys, questions, the file of the scene, tone, lights with their
// time, and a frame with the texts on it. Viewer2 and Viewer3 derive from it. They answer what it asks of the scene,
// and do what events and commands do there.
//
//   (1) nothing is lost: quitting and reading the file again ask where there are unsaved changes; that the file is gone
//       is told, and when it is back it is read, or asked about
//   (2) while lights move, what is shown is the scene after time(); edits, and what is saved, are of the scene as it
//       stands. Where a light cannot be at its time all stand again, and message() says why
class SceneViewer : public Viewer {
 public:
  void handle(const WindowEvent& event) override;
  bool update() override;
  bool wants_quit() const override { return wants_quit_; }
  bool pass_time(const Rational& seconds) override;
  void save_as(const std::filesystem::path& file) override;
  void run() override;

  const Raster& frame() const { return frame_; }
  const std::string& message() const { return message_; }
  const std::optional<Prompt>& prompt() const { return prompt_; }
  // Seconds since the lights began to move; nothing while they stand.
  const std::optional<Rational>& time() const { return time_; }

 protected:
  static constexpr double kReach = 9;  // units that count as touching

  // unit: of letters and lines, in pixels. commands, gestures: that the help shows. REQUIRES: the window outlives it.
  SceneViewer(Window& window, double unit, Tone usual, std::span<const Command> commands,
              std::span<const Gesture> gestures);

  // Each does the command of that name where it is one of its own; else returns false.
  bool frame_command(std::string_view name);  // of tone, of texts, and "fit"
  bool light_command(std::string_view name);
  bool file_command(std::string_view name);

  // Lights stand again where the scene has them.
  void stop();
  // Shows the lights at their time, as far as they may be there.
  void move_lights();

  bool is_still() const;   // the mouse, since a button went down
  bool is_on_bar() const;  // that divides the window
  // Draws what is seen, what was done, and what lies under the mouse. Returns the room for other texts.
  TextRoom draw_head(PictureCanvas& canvas);
  // Draws what is wrong, at the left.
  void draw_warning(PictureCanvas& canvas, std::vector<std::string> lines);
  std::string file_title() const;

  // What a scene of its dimension is asked.
  virtual const SceneTable& table() const = 0;  // the scene as it is edited
  virtual bool is_changed() const = 0;          // since it was saved
  virtual bool is_dragging() const = 0;         // something of the scene

  // Its file. write() makes another file the scene's, and throws as save_as(); why_not_saved() says why that of the
  // scene cannot be written, and is empty where it can.
  virtual const WatchedFile& file() const = 0;
  virtual FileNews file_news() = 0;
  virtual void read_again() = 0;
  virtual void write(const std::filesystem::path& file) = 0;
  virtual std::string why_not_saved() const { return ""; }
  virtual std::string name_to_save_as() const { return file().path().string(); }

  // Its lights. show_lights_after() returns why lights cannot be where they are then, and shows them where they can.
  virtual std::optional<std::uint32_t> light_meant() = 0;
  virtual void add_light() = 0;
  virtual std::vector<Rational> rotation_of(std::uint32_t light) const = 0;
  virtual std::string set_light(std::uint32_t light, const Light& values, std::span<const Rational> rotation) = 0;
  virtual bool can_lights_move() const = 0;
  virtual bool is_light_at_rest() const = 0;
  virtual std::string show_lights_after(const Rational& seconds) = 0;
  virtual void show_lights_standing() = 0;

  // What its events do. The mouse is at the event's place when they are called.
  virtual void press(const WindowEvent& event) = 0;
  virtual void move(const Pixel& before) = 0;
  virtual void release(const WindowEvent& event) = 0;
  virtual void zoom(double times) = 0;  // about what is under the mouse
  virtual bool takes_key(const WindowEvent&) { return false; }
  virtual void size_changed() {}
  virtual void follow_mouse() = 0;   // finds what lies under it
  virtual void scene_changed() = 0;  // tells all others of an edit

  // What it shows.
  virtual void collect() = 0;  // what has come from the background
  virtual void fit() = 0;
  virtual void draw_base() = 0;
  virtual void draw_marks_of_hand(PictureCanvas& canvas) = 0;  // over the base: lights, what is selected
  virtual void draw_texts(PictureCanvas& canvas) = 0;
  virtual std::string head() const = 0;
  virtual std::string status() const = 0;  // of what lies under the mouse
  virtual std::string number() const = 0;  // that can be copied
  virtual bool is_number_behind() const { return false; }

  Window& window_;
  double unit_;
  FrameSize size_;
  ToneChoice tone_;
  bool has_tone_ = false;  // chosen for the first light, or by hand
  double split_ = 0.5;     // where the bar is, of the width
  bool shows_help_ = false;

  Pixel mouse_{}, pressed_{};
  bool has_mouse_ = false, has_moved_ = false;
  MouseButton button_ = MouseButton::kNone;  // that drags
  HeldKeys held_;                            // when it was pressed
  std::optional<LightHold> hover_light_;     // then nothing else lies under the mouse
  std::optional<Prompt> prompt_;
  std::string message_;
  std::optional<Rational> time_;
  Scrolls scrolls_;
  bool needs_base_ = true, needs_frame_ = true;
  Raster base_;

 private:
  void handle_events(double seconds);
  void resize();
  void handle_key(const WindowEvent& event);
  void play();
  void change_light(std::uint32_t light, std::string_view name);
  void ask_for_light(std::uint32_t light);
  void copy_number();
  void reload();
  void watch_file();
  std::string save();
  void quit();
  void draw();

  std::span<const Command> commands_;
  std::span<const Gesture> gestures_;
  bool wants_quit_ = false;
  bool drops_text_ = false;  // that of the key which opened a question
  std::string title_;
  Raster frame_;
  Stopwatch since_watch_;
  double until_watch_ = 0;
};

}  // namespace hottel

// The window in which a scene is edited: events in, frames out.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/support/stopwatch.h"
#include "solver/plane/simulation/simulation_request.h"
#include "viewer/edit/plane/scene_editor.h"
#include "viewer/window/light_legend.h"
#include "viewer/window/panel.h"
#include "viewer/window/plane/camera.h"
#include "viewer/window/plane/scene_file.h"
#include "viewer/window/plane/scene_views.h"
#include "viewer/window/prompt.h"
#include "viewer/window/scroll.h"
#include "viewer/window/viewer.h"
#include "viewer/window/window.h"

namespace hottel {

// The width of the texts at the right: a fraction of the window's width at most.
inline constexpr double kPanelWidth = 0.36;

// The viewer of a scene in the plane: all that a window does, without a screen.
//
//   (1) what is shown is always one state of the scene: its edges and its light belong together. What is being edited
//       is drawn over it at once, in another colour, until its light is there
//   (2) a scene whose light cannot be had is drawn over the last light, dimmed, with the message of `check`
//   (3) while something is dragged, light is on a coarse grid, and the window says so; at rest, state() is that of
//       SceneViews2 (1)
//   (4) nothing is lost: quitting and reading the file again ask where there are unsaved changes; that the file is gone
//       is told, and when it is back it is read, or asked about
//   (5) a command that can do nothing says why in message(): what a key does is seen
//   (6) while lights move, what is shown is scene_after() of the scene at some time since they began, on the coarse
//   grid;
//       edits, and what is saved, are of the scene as it stands
// Its functions are for the thread of the window.
class Viewer2 : public Viewer {
 public:
  // Reads the file. Throws InputError. scale: of letters and lines. REQUIRES: the window outlives it.
  // read: the scene of the file, where that has been read just now. side: from which polygons of a map are seen.
  Viewer2(const std::filesystem::path& file, Window& window, SimulationRequest2 request, double scale,
          std::optional<Scene2> read = {}, MapSide2 side = MapSide2::kInside);

  void handle(const WindowEvent& event) override;
  // Does what a key of that name does (commands.h), at the mouse. Throws UsageError for other names.
  void command(std::string_view name) override;
  bool update() override;
  void settle(double seconds) override;
  bool wants_quit() const override { return wants_quit_; }
  bool pass_time(const Rational& seconds) override;
  Pixel pixel_of_place(std::span<const double> place) const override;
  std::string hashes() const override;  // result_hashes(views().state())
  bool do_own_step(const ScriptStep&) override { return false; }
  void run() override;

  const SceneEditor2& editor() const { return editor_; }
  const SceneViews2& views() const { return views_; }
  const Raster& frame() const { return frame_; }
  const std::string& message() const { return message_; }
  const std::optional<Prompt>& prompt() const { return prompt_; }
  Pixel pixel_of(const Place2& place) const { return camera_.at(place, size_); }

  void save_picture(const std::filesystem::path& file) const override;
  void save_as(const std::filesystem::path& file) override;  // throws as SceneFile2::write

 private:
  enum class Drag : unsigned char { kNone, kEdit, kPan, kBar, kRectangle };
  struct Tool {
    std::vector<Point2> points;
    bool is_edge = true;
    std::uint32_t material = 0;
  };

  // Events.
  void resize();
  void press(const WindowEvent& event);
  void move(const WindowEvent& event);
  void release(const WindowEvent& event);
  void wheel(const WindowEvent& event);
  void click();
  Face asked_face(const Pick2& pick) const;
  std::string asked_name(const Pick2& pick) const;
  void key(const WindowEvent& event);
  void touch();
  Pointer2 pointer(const HeldKeys& held = {}) const;
  Place2 place() const { return camera_.place_of(mouse_, size_); }
  Point2 exact_mouse() const;

  // Commands.
  bool view_command(std::string_view name);
  bool edit_command(std::string_view name);
  bool material_command(std::string_view name);
  bool light_command(std::string_view name);
  bool file_command(std::string_view name);
  std::string why_nothing(std::string_view name) const;
  void next_choice(int step);
  bool nudge(std::string_view name);
  void begin_tool(bool is_edge);
  void add_tool_point();
  void end_tool(bool closed);
  void change_material(std::string_view name, bool copies_first);
  void ask_for_material(bool copies_first);
  std::optional<std::uint32_t> light_meant() const;
  void change_light(std::uint32_t light, std::string_view name);
  void ask_for_light(std::uint32_t light);
  void play();
  void stop();
  void move_lights();
  // The scene that is shown: as edited, or with its lights at their time.
  const std::shared_ptr<const Scene2>& shown_scene() const { return moved_ ? moved_ : editor_.scene(); }
  void ask_for_coordinates();
  std::string save();
  void read_again();
  void quit();
  void watch_file();

  // What is shown.
  void scene_changed();
  void request_changed();
  void fit();
  double panel_width() const;
  std::uint32_t texture_pixels() const;
  void draw_base();
  void draw_marks(PictureCanvas& canvas) const;
  void draw_selection(PictureCanvas& canvas) const;
  void draw_lights(PictureCanvas& canvas) const;
  void draw_tool(PictureCanvas& canvas) const;
  void draw_problem(PictureCanvas& canvas);
  void draw_texts(PictureCanvas& canvas);
  void draw_light_legend(PictureCanvas& canvas, double bottom) const;
  void choose_tone();
  void make_legend();
  ViewDrawing2 drawing() const;
  std::string file_title() const;
  std::string head() const;
  std::string status() const;
  void draw();

  Window& window_;
  double unit_;
  SceneFile2 file_;
  SceneEditor2 editor_;
  SceneViews2 views_;
  FrameSize size_;
  Camera2 camera_;
  ViewRequest2 request_;
  ToneChoice tone_;
  bool has_tone_ = false;  // chosen for the first light, or by hand
  double split_ = 0.5;
  bool shows_help_ = false, wants_quit_ = false;
  bool is_fitted_ = true;  // until the view is moved by hand

  Pixel mouse_{}, pressed_{};
  HeldKeys held_;
  bool has_mouse_ = false;
  Drag drag_ = Drag::kNone;
  MouseButton button_ = MouseButton::kNone;  // that drags
  bool has_moved_ = false;
  bool drops_text_ = false;  // that of the key which opened a prompt
  std::optional<Tool> tool_;
  std::optional<Prompt> prompt_;
  std::string message_, title_;
  Pick2 hover_;
  std::optional<LightHold> hover_light_;  // then hover_ is nothing

  std::shared_ptr<const Scene2> shown_;  // what the rest has been told of
  std::uint64_t shown_version_ = 0;
  std::optional<Rational> time_;         // since lights began to move; none where they stand
  std::shared_ptr<const Scene2> moved_;  // the scene after that time; null until it goes by
  // What light means, of that light through that tone.
  std::optional<LightLegend> legend_;
  std::shared_ptr<const SolvedLight2> legend_of_;
  ToneChoice legend_tone_;
  Scrolls scrolls_;
  bool needs_base_ = true, needs_frame_ = true;
  Raster base_, frame_;
  Stopwatch since_watch_;
  double until_watch_ = 0;
};

}  // namespace hottel

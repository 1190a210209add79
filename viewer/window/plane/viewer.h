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

#include "solver/plane/simulation/simulation.h"
#include "viewer/edit/plane/scene_editor.h"
#include "viewer/window/light_legend.h"
#include "viewer/window/plane/camera.h"
#include "viewer/window/plane/scene_file.h"
#include "viewer/window/plane/scene_views.h"
#include "viewer/window/scene_viewer.h"
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
//   (4) a command that can do nothing says why in message(): what a key does is seen
//   (5) while lights move, light is on the coarse grid
// Its functions are for the thread of the window.
class Viewer2 : public SceneViewer {
 public:
  // Reads the file. Throws InputError. scale: of letters and lines. REQUIRES: the window outlives it.
  // read: the scene of the file, where that has been read just now. side: from which polygons of a map are seen.
  Viewer2(const std::filesystem::path& file, Window& window, SimulationRequest2 request, double scale,
          std::optional<Scene2> read = {}, MapSide2 side = MapSide2::kInside);

  // Does what a key of that name does (commands.h), at the mouse. Throws UsageError for other names.
  void command(std::string_view name) override;
  void settle(double seconds) override;
  Pixel pixel_of_place(std::span<const double> place) const override;
  std::string hashes() const override;  // result_hashes(views().state())
  bool do_own_step(const ScriptStep&) override { return false; }

  const SceneEditor2& editor() const { return editor_; }
  const SceneViews2& views() const { return views_; }
  Pixel pixel_of(const Place2& place) const { return camera_.at(place, size_); }

  void save_picture(const std::filesystem::path& file) const override;

 private:
  enum class Drag : unsigned char { kNone, kEdit, kPan, kBar, kRectangle };
  struct Tool {
    std::vector<Point2> points;
    bool is_edge = true;
    std::uint32_t material = 0;
  };

  // Of the scene and its file.
  const SceneTable& table() const override { return *editor_.scene(); }
  bool is_changed() const override { return editor_.history().is_changed(); }
  bool is_dragging() const override { return editor_.is_dragging(); }
  const WatchedFile& file() const override { return file_; }
  FileNews file_news() override { return file_.news(); }
  void read_again() override;
  void write(const std::filesystem::path& file) override;  // throws as SceneFile2::write

  // Events.
  void press(const WindowEvent& event) override;
  void move(const Pixel& before) override;
  void release(const WindowEvent& event) override;
  void zoom(double times) override;
  void size_changed() override;
  void follow_mouse() override;
  void click();
  Face asked_face(const Pick2& pick) const;
  std::string asked_name(const Pick2& pick) const;
  void touch();
  Pointer2 pointer(const HeldKeys& held = {}) const;
  Place2 place() const { return camera_.place_of(mouse_, size_); }
  Point2 exact_mouse() const;

  // Commands.
  bool view_command(std::string_view name);
  bool edit_command(std::string_view name);
  bool material_command(std::string_view name);
  std::string why_nothing(std::string_view name) const;
  bool nudge(std::string_view name);
  void begin_tool(bool is_edge);
  void add_tool_point();
  void end_tool(bool closed);
  void change_material(std::string_view name, bool copies_first);
  void ask_for_material(bool copies_first);
  // The scene that is shown: as edited, or with its lights at their time.
  const std::shared_ptr<const Scene2>& shown_scene() const { return moved_ ? moved_ : editor_.scene(); }
  void ask_for_coordinates();

  // Lights.
  std::optional<std::uint32_t> light_meant() override;
  void add_light() override { message_ = editor_.add_light(exact_mouse()); }
  std::vector<Rational> rotation_of(std::uint32_t light) const override;
  std::string set_light(std::uint32_t light, const Light& values, std::span<const Rational> rotation) override;
  bool can_lights_move() const override;
  bool is_light_at_rest() const override { return views_.is_at_rest(); }
  std::string show_lights_after(const Rational& seconds) override;
  void show_lights_standing() override;

  // What is shown.
  void collect() override;
  void scene_changed() override;
  void request_changed();
  void fit() override;
  double panel_width() const;
  std::uint32_t texture_pixels() const;
  void draw_base() override;
  void draw_marks(PictureCanvas& canvas) const;
  void draw_marks_of_hand(PictureCanvas& canvas) override;
  void draw_selection(PictureCanvas& canvas) const;
  void draw_lights(PictureCanvas& canvas) const;
  void draw_tool(PictureCanvas& canvas) const;
  void draw_problem(PictureCanvas& canvas);
  void draw_texts(PictureCanvas& canvas) override;
  void draw_light_legend(PictureCanvas& canvas, double bottom) const;
  void choose_tone();
  void make_legend();
  ViewDrawing2 drawing() const;
  std::string head() const override;
  std::string status() const override;
  std::string number() const override { return views_.result() ? views_.result()->number : ""; }
  bool is_number_behind() const override { return views_.is_behind(); }

  SceneFile2 file_;
  SceneEditor2 editor_;
  SceneViews2 views_;
  Camera2 camera_;
  ViewRequest2 request_;
  bool is_fitted_ = true;  // until the view is moved by hand

  Drag drag_ = Drag::kNone;
  std::optional<Tool> tool_;
  Pick2 hover_;

  std::shared_ptr<const Scene2> shown_;  // what the rest has been told of
  std::uint64_t shown_version_ = 0;
  std::shared_ptr<const Scene2> moved_;  // the scene after that time; null until it goes by
  // What light means, of that light through that tone.
  std::optional<LightLegend> legend_;
  std::shared_ptr<const SolvedLight2> legend_of_;
  ToneChoice legend_tone_;
};

}  // namespace hottel

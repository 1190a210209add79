// The window in which one walks through a scene in space and edits it: events in, frames out.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/space/scene/scene.h"
#include "solver/space/simulation/simulation.h"
#include "viewer/edit/space/scene_editor.h"
#include "viewer/picture/picture_options.h"
#include "viewer/picture/raster.h"
#include "viewer/picture/space/seen_picture.h"
#include "viewer/window/background.h"
#include "viewer/window/light_legend.h"
#include "viewer/window/prompt.h"
#include "viewer/window/scroll.h"
#include "viewer/window/space/camera.h"
#include "viewer/window/space/gathered_frame.h"
#include "viewer/window/space/live_scene.h"
#include "viewer/window/space/view_mode.h"
#include "viewer/window/space/viewer_source.h"
#include "viewer/window/viewer.h"
#include "viewer/window/viewer_texts.h"
#include "viewer/window/watched_file.h"
#include "viewer/window/window.h"

namespace hottel {

// The viewer of a scene in space: all that a window does, without a screen.
//
//   (1) the picture is the exact map of the eye (SeenPicture3) at the size of the window: of the light as it is known,
//       light_before_factors_3 first
//   (2) at rest, the light is that of LiveScene3 (1)
//   (3) the eye never gets into a solid, nor a solid around the eye: what would bring it there does nothing, and says
//       so. Neither does a light, nor onto a surface, nor out of all rooms
//   (4) nothing is lost: quitting and reading the file again ask where there are unsaved changes; that the file is gone
//       is told, and when it is back it is read, or asked about
//   (5) a command that can do nothing says why in message(): what a key does is seen
//   (6) while lights move, what is shown is the light of scene_after(scene(), time()): a function of scene and time
//   (7) the wheel and what moves across keep the place that is pointed at under the mouse
//   (8) while polygons are dragged the light is coarse (LiveDepth3), and says so
//   (9) where light is gathered, at rest, squares of what the eye sees have the light of each point (GatheredFrame3) as
//       soon as it is there; until then, and while anything moves, they have that of elements
//   (10) where nothing shines the form of the scene is shown, and where light is nearly even, outlines beside it
// Its functions are for the thread of the window.
class Viewer3 : public Viewer {
 public:
  // Reads the scene. Throws InputError. scale: of letters and lines. REQUIRES: the window outlives it.
  Viewer3(ViewerSource3 source, Window& window, const FactorsRequest3& factors, double scale);

  void handle(const WindowEvent& event) override;
  // Does what a key of that name does (commands_3), at the mouse. Throws UsageError for other names.
  void command(std::string_view name) override;
  bool update() override;
  void settle(double seconds) override;
  bool wants_quit() const override { return wants_quit_; }
  bool pass_time(const Rational& seconds) override;
  Pixel pixel_of_place(std::span<const double> place) const override;
  // factors.csv of `hottel factors`, radiosity.csv of `hottel solve`.
  std::string hashes() const override;
  // orbit, turn, pan, zoom, walk, eye, pick, material (docs/window.md).
  bool do_own_step(const ScriptStep& step) override;
  // At rest light is gathered, unless a key stops that.
  void run() override;

  const SceneEditor3& editor() const { return editor_; }
  const std::shared_ptr<const Scene3>& scene() const { return editor_.scene(); }
  // Seconds since the lights began to move; nothing while they stand.
  const std::optional<Rational>& time() const { return time_; }
  const LiveState3& state() const { return live_.state(); }
  const ViewRequest3& request() const { return request_; }
  // What a frame shows.
  ShownView3 view() const { return result_ ? ShownView3(result_) : ShownView3(state().version); }
  const ViewResult3* result() const { return result_.get(); }
  const EyeCamera3& camera() const { return camera_; }
  const Raster& frame() const { return frame_; }
  const std::string& message() const { return message_; }
  const std::optional<Prompt>& prompt() const { return prompt_; }
  Tone tone() const { return tone_; }
  double exposure() const { return exposure_; }
  bool is_smooth() const { return is_smooth_; }
  bool has_outlines() const { return has_outlines_; }
  // Fraction of the frame whose light is gathered.
  double gathered() const { return gathered_.done(); }
  // The place of the scene that is pointed at: of the surface there, else as far away as what is looked at.
  Direction3 pointed_place(const Pixel& place) const;

  void save_picture(const std::filesystem::path& file) const override;
  void save_as(const std::filesystem::path& file) override;

 private:
  enum class Drag : unsigned char { kNone, kOrbit, kPan, kTurn, kBar, kLight, kEdit };
  // What the camera sees, to be shown anew where nothing but values has changed.
  struct Seen {
    std::shared_ptr<const LiveModel3> model;
    Camera3 camera;
    bool is_smooth = false;
    SeenPicture3 picture;
  };

  // Events.
  void press(const WindowEvent& event);
  Drag drag_of(const WindowEvent& press);
  void move(const Pixel& before);
  void wheel(const WindowEvent& event);
  void key(const WindowEvent& event);
  void move_eye(double right, double down);
  void release(const WindowEvent& event);
  void touch();
  void click();
  void drag_edit();
  bool hold_axis(const WindowEvent& event);
  std::optional<Face> face_at_mouse() const;
  bool knows(const Scene3& other, const Face& face) const;
  Pointer3 pointer(const HeldKeys& held = {}) const;
  std::optional<Direction3> surface_at(const Pixel& place) const;
  bool is_on_bar() const;
  void pick(const std::string& name);
  void unpick();
  void pick(const Face& face);

  // Commands.
  bool view_command(std::string_view name);
  bool walk_command(std::string_view name);
  bool edit_command(std::string_view name);
  bool selection_command(std::string_view name);
  bool add_command(std::string_view name);
  bool light_command(std::string_view name);
  bool material_command(std::string_view name);
  bool file_command(std::string_view name);
  std::optional<std::uint32_t> material_meant();
  void ask_for_material(std::uint32_t material);
  void change_material(std::uint32_t material, const Material& values);
  std::optional<std::uint32_t> light_meant() const;
  void copy_selection();
  void turn_selection(std::string_view name);
  void ask_for_turn();
  void ask_for_corners(bool is_box);
  std::string add_between(bool is_box, bool looks_back, std::uint32_t material, const std::string& text);
  std::uint32_t material_of_new() const;
  void keep_picked(const Scene3& before);
  void tell();
  void change_light(std::uint32_t light, std::string_view name);
  void ask_for_light(std::uint32_t light);
  void ask_for_place();
  void add_light();
  std::string why_not(const Scene3& edited, std::uint32_t light, const Point3* before) const;
  std::string why_not_stand(const Scene3& edited) const;
  void play();
  void move_lights();
  void stop();
  void say(const std::string& done, const char* nothing);
  void drop();
  std::string save();
  void read_again();
  void quit();
  void watch_file();
  void set_scene(Scene3 scene);
  void scene_changed();
  bool is_changed() const { return editor_.history().is_changed(); }

  // What is shown.
  void fit();
  void see(const EyeCamera3& camera);
  void set_request(ViewRequest3 request);
  void ask(bool stops);
  bool is_split() const { return request_.mode == ViewMode3::kErrors && view().values() != nullptr; }
  // What lies under the mouse is of it: the values, where there are some, else the light.
  const Seen* seen() const { return values_ ? &*values_ : light_ ? &*light_ : nullptr; }
  const SeenPicture3::Part* part_at(const Pixel& place) const { return seen() ? seen()->picture.at(place) : nullptr; }
  const SeenPicture3& see(const std::shared_ptr<const LiveModel3>& model, const ElementPaint3& paint, bool is_smooth,
                          std::optional<Seen>& kept) const;
  void draw_seen();
  void draw_base();
  void draw_lights(PictureCanvas& canvas) const;
  bool is_hidden(const Direction3& place) const;
  void draw_problem(PictureCanvas& canvas);
  void draw_touched(PictureCanvas& canvas) const;
  void draw_selection(PictureCanvas& canvas) const;
  void draw_texts(PictureCanvas& canvas);
  std::vector<SideText> side_texts() const;
  void draw_legends(PictureCanvas& canvas, double bottom) const;
  void choose_tone();
  void gather();
  std::string gathering_text() const;
  void add_outlines(const SeenPicture3& picture);
  std::string file_title() const;
  std::string head() const;
  std::string status() const;
  void draw();

  Window& window_;
  double unit_;
  ViewerSource3 source_;
  WatchedFile file_;
  LiveScene3 live_;
  SceneEditor3 editor_;
  std::shared_ptr<const Scene3> told_;   // of which the rest has been told
  std::shared_ptr<const Scene3> shown_;  // the same, or, while lights move, at their time
  std::optional<Rational> time_;

  FrameSize size_;
  EyeCamera3 camera_;
  Camera3 home_;
  bool is_fitted_ = false;  // home_ is that of the scene, or chosen for it
  ViewRequest3 request_;
  std::shared_ptr<const ViewResult3> result_;  // of its request
  LiveVersion3::Ptr asked_of_;                 // the version of which a result was last asked for
  Background computing_;
  Tone tone_ = kUsualTone3;
  double exposure_ = 1, split_ = 0.5;
  bool has_tone_ = false;      // chosen for the first light, or by hand
  bool has_outlines_ = false;  // the same
  bool is_smooth_ = true, shows_help_ = false, wants_quit_ = false;
  bool gathers_ = false;  // at rest

  Pixel mouse_{}, pressed_{};
  bool has_mouse_ = false, has_moved_ = false;
  bool drops_text_ = false;  // that of the key which opened a prompt
  Drag drag_ = Drag::kNone;
  MouseButton button_ = MouseButton::kNone;  // that drags
  HeldKeys held_;                            // when it was pressed
  Direction3 grabbed_{};                     // what is dragged by moving across
  std::optional<Prompt> prompt_;
  std::string message_, title_;
  std::optional<LiveElement3> hover_, picked_;
  std::optional<LightHold> hover_light_;  // then hover_ is nothing

  std::optional<Seen> light_, values_;  // values_: nothing where light alone is shown
  ElementPaint3 paint_;                 // of the light that is shown
  std::optional<LightLegend> legend_;   // what it means
  GatheredFrame3 gathered_;
  Scrolls scrolls_;
  bool needs_base_ = true, needs_frame_ = true;
  Raster base_, frame_;
  Stopwatch since_watch_;
  double until_watch_ = 0;
};

}  // namespace hottel

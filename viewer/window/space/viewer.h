// The window in which one walks through a scene in space and edits it: events in, frames out.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
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
#include "viewer/picture/space/seen_picture.h"
#include "viewer/window/background.h"
#include "viewer/window/light_legend.h"
#include "viewer/window/scene_viewer.h"
#include "viewer/window/space/camera.h"
#include "viewer/window/space/gathered_frame.h"
#include "viewer/window/space/live_scene.h"
#include "viewer/window/space/view_mode.h"
#include "viewer/window/watched_file.h"
#include "viewer/window/window.h"

namespace hottel {

// Where the scene of a viewer comes from.
struct ViewerSource3 {
  std::filesystem::path file;
  std::function<Scene3()> read;  // throws InputError
};

// The viewer of a scene in space: all that a window does, without a screen.
//
//   (1) the picture is the exact map of the eye (SeenPicture3) at the size of the window: of the light as it is known,
//       light_before_factors_3 first
//   (2) at rest, the light is that of LiveScene3 (1)
//   (3) the eye never gets into a solid, nor a solid around the eye: what would bring it there does nothing, and says
//       so. Neither does a light, nor onto a surface, nor out of all rooms
//   (4) a command that can do nothing says why in message(): what a key does is seen
//   (5) the wheel and what moves across keep the place that is pointed at under the mouse
//   (6) while polygons are dragged the light is coarse (LiveDepth3), and says so
//   (7) where light is gathered, at rest, squares of what the eye sees have the light of each point (GatheredFrame3) as
//       soon as it is there; until then, and while anything moves, they have that of elements
//   (8) where nothing shines the form of the scene is shown, and where light is nearly even, outlines beside it
// Its functions are for the thread of the window.
class Viewer3 : public SceneViewer {
 public:
  // Reads the scene. Throws InputError. scale: of letters and lines. REQUIRES: the window outlives it.
  Viewer3(ViewerSource3 source, Window& window, const FactorsRequest3& factors, double scale);

  // Does what a key of that name does (commands_3), at the mouse. Throws UsageError for other names.
  void command(std::string_view name) override;
  void settle(double seconds) override;
  Pixel pixel_of_place(std::span<const double> place) const override;
  // factors.csv of `hottel factors`, radiosity.csv of `hottel solve`.
  std::string hashes() const override;
  // orbit, turn, pan, zoom, walk, eye, pick, material (docs/window.md).
  bool do_own_step(const ScriptStep& step) override;
  // At rest light is gathered, unless a key stops that.
  void run() override;

  const SceneEditor3& editor() const { return editor_; }
  const std::shared_ptr<const Scene3>& scene() const { return editor_.scene(); }
  const LiveState3& state() const { return live_.state(); }
  const ViewRequest3& request() const { return request_; }
  // What a frame shows.
  ShownView3 view() const { return result_ ? ShownView3(result_) : ShownView3(state().version); }
  const ViewResult3* result() const { return result_.get(); }
  const EyeCamera3& camera() const { return camera_; }
  Tone tone() const { return tone_.tone; }
  double exposure() const { return tone_.exposure; }
  bool is_smooth() const { return is_smooth_; }
  bool has_outlines() const { return has_outlines_; }
  // Fraction of the frame whose light is gathered.
  double gathered() const { return gathered_.done(); }
  // The place of the scene that is pointed at: of the surface there, else as far away as what is looked at.
  Direction3 pointed_place(const Pixel& place) const;

  void save_picture(const std::filesystem::path& file) const override;

 private:
  enum class Drag : unsigned char { kNone, kOrbit, kPan, kTurn, kBar, kLight, kEdit };
  // What the camera sees, to be shown anew where nothing but values has changed.
  struct Seen {
    std::shared_ptr<const LiveModel3> model;
    Camera3 camera;
    bool is_smooth = false;
    SeenPicture3 picture;
  };

  // Of the scene and its file.
  const SceneTable& table() const override { return *scene(); }
  bool is_changed() const override { return editor_.history().is_changed(); }
  bool is_dragging() const override { return editor_.is_dragging(); }
  const WatchedFile& file() const override { return file_; }
  FileNews file_news() override { return file_.news(); }
  void read_again() override;
  void write(const std::filesystem::path& file) override;
  std::string why_not_saved() const override;
  std::string name_to_save_as() const override;

  // Events.
  void press(const WindowEvent& event) override;
  Drag drag_of(const WindowEvent& press);
  void move(const Pixel& before) override;
  void zoom(double times) override;
  void move_eye(double right, double down);
  void release(const WindowEvent& event) override;
  void follow_mouse() override { touch(); }
  void touch();
  void click();
  void drag_edit();
  bool takes_key(const WindowEvent& event) override;  // for an axis, while something is dragged
  std::optional<Face> face_at_mouse() const;
  bool knows(const Scene3& other, const Face& face) const;
  Pointer3 pointer(const HeldKeys& held = {}) const;
  std::optional<Direction3> surface_at(const Pixel& place) const;
  void pick(const std::string& name);
  void unpick();
  void pick(const Face& face);

  // Commands.
  bool view_command(std::string_view name);
  bool walk_command(std::string_view name);
  bool edit_command(std::string_view name);
  bool selection_command(std::string_view name);
  bool add_command(std::string_view name);
  bool material_command(std::string_view name);
  std::optional<std::uint32_t> material_meant();
  void ask_for_material(std::uint32_t material);
  void change_material(std::uint32_t material, const Material& values);
  void copy_selection();
  void turn_selection(std::string_view name);
  void ask_for_turn();
  void ask_for_corners(bool is_box);
  std::string add_between(bool is_box, bool looks_back, std::uint32_t material, const std::string& text);
  std::uint32_t material_of_new() const;
  void keep_picked(const Scene3& before);
  void tell();
  void ask_for_place();
  std::string why_not(const Scene3& edited, std::uint32_t light, const Point3* before) const;
  std::string why_not_stand(const Scene3& edited) const;
  void say(const std::string& done, const char* nothing);
  void drop();
  void set_scene(Scene3 scene);
  void scene_changed() override;

  // Lights.
  std::optional<std::uint32_t> light_meant() override;
  void add_light() override;
  std::vector<Rational> rotation_of(std::uint32_t light) const override;
  std::string set_light(std::uint32_t light, const Light& values, std::span<const Rational> rotation) override;
  bool can_lights_move() const override;
  bool is_light_at_rest() const override { return live_.is_at_rest(); }
  std::string show_lights_after(const Rational& seconds) override;
  void show_lights_standing() override;

  // What is shown.
  void collect() override;
  void fit() override;
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
  void draw_base() override;
  void draw_marks_of_hand(PictureCanvas& canvas) override;
  void draw_lights(PictureCanvas& canvas) const;
  bool is_hidden(const Direction3& place) const;
  void draw_problem(PictureCanvas& canvas);
  void draw_touched(PictureCanvas& canvas) const;
  void draw_selection(PictureCanvas& canvas) const;
  void draw_texts(PictureCanvas& canvas) override;
  std::vector<SideText> side_texts() const;
  void draw_legends(PictureCanvas& canvas, double bottom) const;
  void choose_tone();
  void gather();
  std::string gathering_text() const;
  void add_outlines(const SeenPicture3& picture);
  std::string head() const override;
  std::string status() const override;
  std::string number() const override { return view().number(hover_); }

  ViewerSource3 source_;
  WatchedFile file_;
  LiveScene3 live_;
  SceneEditor3 editor_;
  std::shared_ptr<const Scene3> told_;   // of which the rest has been told
  std::shared_ptr<const Scene3> shown_;  // the same, or, while lights move, at their time

  EyeCamera3 camera_;
  Camera3 home_;
  bool is_fitted_ = false;  // home_ is that of the scene, or chosen for it
  ViewRequest3 request_;
  std::shared_ptr<const ViewResult3> result_;  // of its request
  LiveVersion3::Ptr asked_of_;                 // the version of which a result was last asked for
  Background computing_;
  bool has_outlines_ = false;  // chosen as has_tone_ says
  bool is_smooth_ = true;
  bool gathers_ = false;  // at rest

  Drag drag_ = Drag::kNone;
  Direction3 grabbed_{};  // what is dragged by moving across
  std::optional<LiveElement3> hover_, picked_;

  std::optional<Seen> light_, values_;  // values_: nothing where light alone is shown
  ElementPaint3 paint_;                 // of the light that is shown
  std::optional<LightLegend> legend_;   // what it means
  GatheredFrame3 gathered_;
};

}  // namespace hottel

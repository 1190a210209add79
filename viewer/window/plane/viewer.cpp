#include "viewer/window/plane/viewer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "io/files/output_file.h"
#include "kernel/support/failure.h"
#include "viewer/picture/cairo_canvas.h"
#include "viewer/picture/plane/drawable.h"
#include "viewer/window/plane/viewer_script.h"

namespace hottel {
namespace {

constexpr std::uint32_t kMostPixelsPerCell = 8;
constexpr double kEvenLight = 2;  // the brightest over the mean, below which light is even
constexpr double kFreeSides = 40, kFreeTop = 64, kFreeBottom = 134;     // units around the scene
constexpr double kMostSide = 0.1, kMostTop = 0.16, kMostBottom = 0.34;  // of the window: half of it is the scene's

}  // namespace

Viewer2::Viewer2(const std::filesystem::path& file, Window& window, SimulationRequest2 request, double scale,
                 std::optional<Scene2> read, MapSide2 side)
    : SceneViewer(window, scale, kUsualTone2, commands(), gestures()),
      file_(file, side),
      editor_(read ? std::move(*read) : file_.read()),
      views_(std::move(request), [&window] { window.wake(); }) {
  if (read) file_.note();
  require_drawable(*editor_.scene());
  fit();
  scene_changed();
}

void Viewer2::fit() {
  const double beside = panel_width();
  const FrameSize room{static_cast<std::uint32_t>(std::max(1.0, size_.width - beside)), size_.height};
  const double top = std::min(kFreeTop * unit_, kMostTop * size_.height);
  const double bottom = std::min(kFreeBottom * unit_, kMostBottom * size_.height);
  camera_.fit(*editor_.scene(), room, std::min(kFreeSides * unit_, kMostSide * room.width), top, bottom);
  camera_.pan(-beside / 2, 0);
  is_fitted_ = true;
  needs_base_ = true;
  views_.set_tone(tone_, texture_pixels());
}

// The room that long texts take at the right.
double Viewer2::panel_width() const {
  const bool has_panel = request_.mode == ViewMode2::kVisibility || request_.mode == ViewMode2::kPair ||
                         request_.mode == ViewMode2::kCheck || request_.mode == ViewMode2::kPlan;
  return has_panel ? kPanelWidth * size_.width : 0;
}

// As fine as the screen shows a cell.
std::uint32_t Viewer2::texture_pixels() const {
  const auto lit = views_.lit();
  if (!lit) return 1;
  const Grid2& grid = lit->light->grid.grid;
  const double cell = to_double((grid.max.x - grid.min.x) / grid.nx) * camera_.pixels_per_length();
  return static_cast<std::uint32_t>(std::clamp(std::ceil(cell), 1.0, double{kMostPixelsPerCell}));
}

void Viewer2::scene_changed() {
  needs_frame_ = true;
  if (shown_version_ == editor_.version()) return;
  shown_version_ = editor_.version();
  if (time_)
    move_lights();
  else
    views_.set_scene(editor_.scene(), editor_.is_dragging() ? LiveDepth2::kCoarse : LiveDepth2::kFull);
  shown_ = editor_.scene();
  for (std::optional<std::string>* name : {&request_.face, &request_.other})
    if (!face_called(*shown_, *name)) name->reset();
  if (tool_ && tool_->material >= shown_->materials.size()) tool_.reset();
  touch();
}

// The request follows the mouse, and what lies under it, if the view mode depends on them.
void Viewer2::request_changed() {
  const bool is_free = has_mouse_ && drag_ == Drag::kNone;
  const bool follows =
      request_.mode == ViewMode2::kVisibility ? has_mouse_ : is_free && shows_light_at_mouse(request_.mode);
  request_.mouse = follows ? std::optional(exact_mouse()) : std::nullopt;
  if (request_.mode == ViewMode2::kFactors)
    request_.other = hover_.surface && is_free ? std::optional(asked_name(hover_)) : std::nullopt;
  if (request_.mode != ViewMode2::kFactors && request_.mode != ViewMode2::kPair) request_.other.reset();
  views_.set_request(request_);
  needs_frame_ = true;
}

void Viewer2::collect() {
  if (!views_.collect()) return;
  needs_base_ = true;
  choose_tone();
  views_.set_tone(tone_, texture_pixels());
}

void Viewer2::settle(double seconds) {
  update();
  if (!views_.wait(seconds))
    throw RequestError(fmt::format("{}: the light is not there after {} s", file_.path().string(), seconds));
  update();
  views_.wait(seconds);  // what the light at rest asks for: a finer texture
  update();
}

Pixel Viewer2::pixel_of_place(std::span<const double> place) const {
  if (place.size() != 2) throw UsageError("a place of a scene in the plane is X,Y");
  return pixel_of({place[0], place[1]});
}

std::string Viewer2::hashes() const { return result_hashes(views_.state()); }

// The first light that there is tells the tone, unless a hand has.
void Viewer2::choose_tone() {
  const auto lit = views_.lit();
  if (has_tone_ || !lit || !shines(lit->light->grid)) return;
  has_tone_ = true;
  tone_ = first_tone(lit->light->grid.values, lit->light->grid.channels, kEvenLight, kUsualTone2);
}

void Viewer2::read_again() {
  try {
    Scene2 scene = file_.read();
    require_drawable(scene);
    editor_.replace(std::move(scene));
    time_.reset();
    moved_.reset();
    drag_ = Drag::kNone;
    message_ = "read again";
    if (is_fitted_) fit();
  } catch (const std::runtime_error& error) {
    message_ = error.what();
  }
  scene_changed();
}

void Viewer2::write(const std::filesystem::path& file) {
  file_.write_as(file, *editor_.scene());
  editor_.mark_saved();
}

void Viewer2::save_picture(const std::filesystem::path& file) const {
  const auto format = picture_format(file.string());
  if (!format) throw UsageError("a picture ends in .png, .svg or .pdf, not '" + file.string() + "'");
  CairoCanvas canvas(*format, size_.width, size_.height);
  draw_marks(canvas);
  write_output_file(file, canvas.finish());
}

}  // namespace hottel

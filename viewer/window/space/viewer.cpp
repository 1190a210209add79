#include "viewer/window/space/viewer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <thread>
#include <utility>

#include "geometry/name.h"
#include "geometry/scene_names.h"
#include "io/files/output_file.h"
#include "io/results/factor_files.h"
#include "io/results/radiosity_files.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "viewer/edit/material_edits.h"
#include "viewer/edit/space/typed_point.h"
#include "viewer/picture/png_file.h"
#include "viewer/picture/space/camera_view.h"
#include "viewer/picture/space/render_picture.h"
#include "viewer/window/script_player.h"
#include "viewer/window/space/commands.h"
#include "viewer/window/written_hash.h"

namespace hottel {
namespace {

// The brightest over the mean, below which light is even, and faces are hard to tell apart.
constexpr double kEvenLight = 3, kEvenForms = 4;

// The longest side of the box around the scene; 1 where there is none.
double size_of(const Scene3& scene) {
  double size = 0;
  for (Rational Point3::*axis : {&Point3::x, &Point3::y, &Point3::z}) {
    std::optional<Rational> low, high;
    for (const Polygon3& polygon : scene.polygons)
      for (const Point3& p : polygon.points) {
        if (!low || p.*axis < *low) low = p.*axis;
        if (!high || p.*axis > *high) high = p.*axis;
      }
    if (low) size = std::max(size, to_double(*high - *low));
  }
  return size > 0 ? size : 1;
}

// "1,2,3" as it is typed.
Point3 exact_place(const std::string& text) {
  const Typed<Point3> typed = typed_point_3(text);
  if (!typed.value) throw UsageError("a place is X,Y,Z, not '" + text + "'");
  return *typed.value;
}

SimulationRequest3 request_of(FactorsRequest3 factors) {
  factors.granularity = Granularity::kElement;
  factors.wants_visibility = true;
  return {.factors = std::move(factors), .system = {.serves_many = true}};
}

}  // namespace

Viewer3::Viewer3(ViewerSource3 source, Window& window, const FactorsRequest3& factors, double scale)
    : SceneViewer(window, scale, kUsualTone3, commands_3(), gestures_3()),
      source_(std::move(source)),
      file_(source_.file),
      live_(request_of(factors), [&window] { window.wake(); }),
      editor_(
          {},
          [this](const Scene3& edited, std::uint32_t light, const Point3* before) {
            return why_not(edited, light, before);
          },
          [this](const Scene3& edited) { return why_not_stand(edited); }),
      computing_([&window] { window.wake(); }),
      gathered_([&window] { window.wake(); }) {
  file_.note();
  set_scene(source_.read());
}

void Viewer3::set_scene(Scene3 scene_read) {
  const auto read = std::make_shared<const Scene3>(std::move(scene_read));
  live_.set(read);  // throws before anything has changed
  live_.forget();
  editor_.replace(read);
  told_ = shown_ = read;
  time_.reset();
  drag_ = Drag::kNone;
  hover_light_.reset();
  hover_.reset();
  picked_.reset();
  light_.reset();
  values_.reset();
  is_fitted_ = false;
  request_.face.reset();
  result_.reset();
  computing_.cancel();
  if (read->camera) {
    home_ = *read->camera;
    is_fitted_ = true;
    fit();
  }
  needs_base_ = true;
}

// Tells the light of another scene.
void Viewer3::scene_changed() {
  needs_frame_ = true;
  if (told_ == scene()) return;
  keep_picked(*std::exchange(told_, scene()));
  tell();
}

// While polygons are dragged the light is coarse.
void Viewer3::tell() {
  if (time_) return move_lights();
  shown_ = told_;
  live_.set(shown_, drag_ == Drag::kEdit && editor_.is_dragging() ? LiveDepth3::kCoarse : LiveDepth3::kFull);
  if (drag_ != Drag::kLight && drag_ != Drag::kEdit) touch();
}

void Viewer3::fit() { camera_ = EyeCamera3(home_, size_of(*scene())); }

// Moves the eye, unless that brings it into a solid.
void Viewer3::see(const EyeCamera3& camera) {
  if (const auto& version = state().version)
    if (const auto mesh = version->model().prepared.arrangement().solids().around(camera.camera(size_).eye)) {
      const Solids3& solids = version->model().prepared.arrangement().solids();
      message_ = "there is the solid " + quoted_name(solids.meshes()[*mesh].name);
      return;
    }
  camera_ = camera;
  needs_base_ = true;
}

void Viewer3::collect() {
  const bool has_come = live_.collect();
  const bool has_result = computing_.collect();
  if (state().version && !is_fitted_) {
    home_ = default_camera_3(state().version->model().prepared);
    is_fitted_ = true;
    fit();
  }
  const bool has_gathered = gathered_.collect();
  if (has_come || has_result || has_gathered) needs_base_ = true;
  choose_tone();
  gather();
  if (state().version != asked_of_) ask(request_.mode == ViewMode3::kSweeps);
}

// The first light that there is tells the tone, unless a hand has.
void Viewer3::choose_tone() {
  if (has_tone_ || !state().is_lit() || !live_.is_at_rest()) return;
  const ElementPaint3& light = state().version->light();
  const bool shines = std::ranges::any_of(light.values, [](double value) { return value > 0; });
  needs_base_ = needs_base_ || shines || !has_outlines_;
  has_outlines_ = !shines || is_nearly_even(light.values, light.channels, kEvenForms);
  if (!shines) return;
  has_tone_ = true;
  tone_ = first_tone(light.values, light.channels, kEvenLight, kUsualTone3);
}

void Viewer3::settle(double seconds) {
  update();
  Stopwatch watch;
  for (double waited = 0;; waited += watch.lap()) {
    live_.wait(seconds - waited);
    update();  // what has come may ask for a result
    if (live_.is_at_rest() && !computing_.is_busy() && !gathered_.is_busy()) return;
    if (waited > seconds)
      throw RequestError(fmt::format("{}: the light is not there after {} s", file_.path().string(), seconds));
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

void Viewer3::run() {
  gathers_ = true;
  SceneViewer::run();
}

void Viewer3::set_request(ViewRequest3 request) {
  if (request == request_) return;
  request_ = std::move(request);
  result_.reset();
  needs_base_ = true;
  ask(true);
}

// Asks for the result of the view mode, from the version that is shown. It stops what runs, or follows it: then a
// result of a version before is shown until there is another, so that something new comes however fast versions follow.
void Viewer3::ask(bool stops) {
  asked_of_ = state().version;
  if (result_ && state().version && result_->version->scene().polygons != state().version->scene().polygons)
    result_.reset();
  const bool is_of_face = request_.mode == ViewMode3::kFactors && request_.face;
  const bool has_face = !is_of_face || (state().version && knows(state().version->scene(), *request_.face));
  if (!needs_work(request_) || !state().is_lit() || !has_face) {
    computing_.cancel();
    result_.reset();
    return;
  }
  Background::Work work = [this, version = state().version, request = request_](const StageProgress& progress,
                                                                                const Background::Tell& tell) {
    const auto apply = [this](ViewResult3 result) {
      return [this, result = std::make_shared<const ViewResult3>(std::move(result))] { result_ = result; };
    };
    return Background::Apply(
        apply(compute_view_3(version, request, progress, [&](ViewResult3 so_far) { tell(apply(std::move(so_far))); })));
  };
  stops ? computing_.post(std::move(work)) : computing_.follow(std::move(work));
}

void Viewer3::read_again() {
  try {
    file_.note();
    const EyeCamera3 before = camera_;
    const bool was_fitted = is_fitted_;
    set_scene(source_.read());
    if (was_fitted) {  // the eye stays where it is
      is_fitted_ = true;
      camera_ = before;
    }
    message_ = "read again";
  } catch (const std::runtime_error& error) {
    message_ = error.what();
  }
}

std::string Viewer3::why_not_saved() const {
  return file_.path().extension() == ".json" ? "" : "a scene is saved as .json: use ctrl+shift+s for another name";
}

std::string Viewer3::name_to_save_as() const {
  return std::filesystem::path(file_.path()).replace_extension(".json").string();
}

void Viewer3::write(const std::filesystem::path& file) {
  if (file.extension() != ".json") throw UsageError("a scene is saved as .json, not '" + file.string() + "'");
  if (std::ranges::any_of(scene()->groups, [](const Group& group) { return group.behind != Behind::kByOutline; }))
    throw RequestError("a scene whose meshes say what is \"behind\" them cannot be written");
  write_output_file(file, write_scene_3(*scene()));
  source_ = {file, [file] { return read_scene_3(file); }};
  file_ = WatchedFile(file);
  file_.note();
  editor_.mark_saved();
}

void Viewer3::save_picture(const std::filesystem::path& file) const {
  const auto format = picture_format(file.string());
  if (!format) throw UsageError("a picture ends in .png, .svg or .pdf, not '" + file.string() + "'");
  if (gathered_.done() > 0 && *format == PictureFormat::kPng) return write_output_file(file, png_file(base_));
  const ShownView3 view = this->view();
  if (view.radiosities() == nullptr)
    throw RequestError("there is no light to draw" + (state().problem.empty() ? "" : ": " + state().problem));
  PreparedScene3 prepared = *view.version()->of().simulation().prepared();
  prepared.scene.camera = camera_.camera(size_);
  RenderOptions3 options{.tone = tone_.tone, .exposure = tone_.exposure};
  if (is_smooth_) options.shading = Shading::kSmooth;
  if (view.values() != nullptr) options.shown = *view.values();
  write_output_file(
      file, RenderedView3(prepared, Granularity::kElement, *view.radiosities(), std::move(options)).file(*format));
}

std::string Viewer3::hashes() const {
  if (!state().is_lit() || state().version->of().scene() != scene() || !state().problem.empty())
    return "factors.csv - radiosity.csv -";
  const LiveVersion3& version = *state().version;
  SimulationRequest3 request = version.of().whole().request();
  request.factors.wants_visibility = true;
  const auto factors = version.of().whole().with_request(request).factors();
  SimulationRequest3 of_solve = version.of().simulation().request();  // which solves for one light
  of_solve.system = {};
  const auto radiosities = version.of().simulation().with_request(of_solve).radiosities();
  return fmt::format("factors.csv {} radiosity.csv {}", written_hash([&](const Sink& sink) {
                       write_factors_csv({version.scene(), factors->matrix, Granularity::kFace, {}, {}}, sink);
                     }),
                     written_hash([&](const Sink& sink) {
                       write_radiosity_csv(version.scene(), version.factors()->matrix, *radiosities, sink);
                     }));
}

Pixel Viewer3::pixel_of_place(std::span<const double> place) const {
  if (place.size() != 3) throw UsageError("a place of a scene in space is X,Y,Z");
  const std::optional<Pixel> at = camera_.at({place[0], place[1], place[2]}, size_);
  if (!at) throw UsageError("this place is not in front of the eye");
  return *at;
}

bool Viewer3::do_own_step(const ScriptStep& step) {
  constexpr std::array kOwn{"orbit", "turn", "pan", "zoom", "walk", "pick", "material", "eye"};
  if (std::ranges::find(kOwn, step.word) == kOwn.end()) return false;
  const auto numbers = [&](std::size_t most) {
    std::vector<double> result;
    for (const std::string& argument : step.arguments)
      if (!read_script_number(argument, result.emplace_back()))
        throw UsageError("'" + step.word + "' takes numbers, not '" + argument + "'");
    result.resize(most, 0);
    return result;
  };
  EyeCamera3 camera = camera_;
  message_.clear();
  needs_frame_ = true;
  if (step.word == "orbit") {
    camera.orbit(numbers(2)[0], numbers(2)[1]);
  } else if (step.word == "turn") {
    camera.turn(numbers(2)[0], numbers(2)[1]);
  } else if (step.word == "pan") {
    camera.pan(numbers(2)[0], numbers(2)[1]);
  } else if (step.word == "zoom") {
    if (!(numbers(1)[0] > 0)) throw UsageError("'zoom' divides the distance by a number above 0");
    camera.zoom(numbers(1)[0]);
  } else if (step.word == "walk") {
    camera.walk(numbers(3)[0], numbers(3)[1], numbers(3)[2]);
  } else if (step.word == "pick") {
    const std::string name = step.rest.substr(0, step.rest.find_last_not_of(" \t") + 1);
    pick(name);
    return true;
  } else if (step.word == "material") {
    const auto& materials = scene()->materials;
    const auto found = std::ranges::find(materials, step.arguments[0], &Material::name);
    if (found == materials.end()) throw UsageError("there is no material '" + step.arguments[0] + "'");
    Material values = *found;
    const std::string problem = read_material(step.rest.substr(step.arguments[0].size()), values);
    if (!problem.empty()) throw UsageError(problem);
    change_material(static_cast<std::uint32_t>(found - materials.begin()), values);
    return true;
  } else {
    Camera3 moved = camera_.camera(size_);
    moved.eye = exact_place(step.arguments[0]);
    moved.target = exact_place(step.arguments[1]);
    if (const std::string problem = camera_problem(moved); !problem.empty()) throw UsageError(problem);
    camera = EyeCamera3(moved, camera_.size());
  }
  see(camera);
  return true;
}

}  // namespace hottel

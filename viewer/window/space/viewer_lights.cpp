// What a viewer in space does to lights, and how it draws them.
#include <algorithm>
#include <array>

#include "geometry/space/scene/light_place_problem.h"
#include "geometry/space/scene/moving_lights.h"
#include "viewer/edit/decimals.h"
#include "viewer/edit/light_edits.h"
#include "viewer/edit/space/light_region.h"
#include "viewer/window/lights.h"
#include "viewer/window/space/light_lines.h"
#include "viewer/window/space/viewer.h"

namespace hottel {
namespace {

constexpr double kBesideSurface = 0.1;  // sizes of the scene from what is seen to a light that is put there
constexpr double kHidden = 1e-6;        // of the way to a light, that what hides it is nearer

// What is wrong with where a light is, as a sentence; empty when nothing is.
std::string place_problem(const Scene3& scene, std::uint32_t light) {
  const std::string problem = light_place_problem(scene, scene.lights[light], scene.light_places[light]);
  return problem.empty() ? "" : scene.lights[light].name + " " + problem;
}

}  // namespace

// The light under the mouse; where no polygon is there either, the one that is selected.
std::optional<std::uint32_t> Viewer3::light_meant() const {
  if (hover_light_) return hover_light_->light;
  return hover_ ? std::nullopt : editor_.selected_light();
}

// Tells what was done, or why nothing was.
void Viewer3::say(const std::string& done, const char* nothing) {
  message_ = !done.empty() ? done : !editor_.refusal().empty() ? editor_.refusal() : nothing;
}

bool Viewer3::light_command(std::string_view name) {
  touch();
  if (name == "light" || name == "play") {
    name == "light" ? add_light() : play();
    return true;
  }
  if (name != "material" && !is_light_edit(name)) return false;
  const std::optional<std::uint32_t> light = light_meant();
  if (!light && name == "spin") message_ = "no light lies under the mouse, and none is selected";
  if (!light) return name == "spin";
  name == "material" ? ask_for_light(*light) : change_light(*light, name);
  return true;
}

void Viewer3::change_light(std::uint32_t light, std::string_view name) {
  Light values = scene()->lights[light];
  const Vector3& rates = scene()->light_places[light].rotation;
  std::array<Rational, 3> rotation{rates.x, rates.y, rates.z};
  edit_light(values, rotation, name);
  const Vector3 rates_after{rotation[0], rotation[1], rotation[2]};
  const std::string changed = editor_.change_light(light, values, rates_after);
  if (name == "spin" && !changed.empty() && !time_ && !rates_after.is_zero()) time_ = 0;
  if (changed.empty())
    message_ = editor_.is_dragging() ? "not while something is dragged" : why_light_stays(name);
  else if (!hover_light_)  // what lies under the mouse is told already
    message_ = light_line_3(*scene(), light);
}

// Lights begin to move, or stand again where the scene has them.
void Viewer3::play() {
  if (time_)
    stop();
  else
    message_ = begin_to_move(time_, editor_.is_dragging(), has_moving_lights(*scene()));
}

void Viewer3::stop() {
  time_.reset();
  shown_ = told_;
  live_.set(shown_);
  message_ = "the lights stand";
}

bool Viewer3::pass_time(const Rational& seconds) {
  if (!time_) return false;
  *time_ += seconds;
  if (seconds > 0 && live_.is_at_rest()) move_lights();
  return true;
}

// Shows the lights at their time, as far as they may be there.
void Viewer3::move_lights() {
  needs_frame_ = true;
  const auto moved = std::make_shared<const Scene3>(scene_after(*scene(), *time_));
  std::string problem = has_moving_lights(*scene()) ? "" : "no light moves";
  for (std::uint32_t k = 0; k < moved->lights.size() && problem.empty(); ++k)
    if (moved->light_places[k].position != scene()->light_places[k].position) problem = place_problem(*moved, k);
  if (!problem.empty()) {
    const std::string why = why_lights_stand(*time_, problem);
    stop();
    message_ = why;
    return;
  }
  shown_ = moved;
  live_.set(shown_);
}

void Viewer3::ask_for_light(std::uint32_t light) {
  const Vector3& rates = scene()->light_places[light].rotation;
  prompt_ = light_prompt(scene()->lights[light], {rates.x, rates.y, rates.z},
                         [this, light](const Light& values, std::span<const Rational> rotation) {
                           editor_.change_light(light, values, {rotation[0], rotation[1], rotation[2]});
                           scene_changed();
                         });
}

// A point light before the surface under the mouse; where none is, as far away as what is looked at.
void Viewer3::add_light() {
  if (!has_mouse_) {
    message_ = "the mouse is not there";
    return;
  }
  const Pointer3 hand = pointer();
  const Direction3 ray = unit(hand.way_to(hand.at));
  const std::optional<Direction3> surface = surface_at(mouse_);
  const double way = surface ? length(*surface - hand.eye) : camera_.distance();
  const Direction3 at = hand.eye + (surface ? std::max(way / 2, way - kBesideSurface * camera_.size()) : way) * ray;
  const int decimals = decimals_at(1 / hand.length_of_pixel(at));
  say(editor_.add_light(
          {rounded_decimal(at.x, decimals), rounded_decimal(at.y, decimals), rounded_decimal(at.z, decimals)}),
      "not while something is dragged");
}

// Why a light may not be where it is; before there is a model, as far as the scene tells.
std::string Viewer3::why_not(const Scene3& edited, std::uint32_t light, const Point3* before) const {
  const LiveVersion3* version = state().version.get();
  if (version == nullptr || version->scene().polygons != edited.polygons) return place_problem(edited, light);
  return light_refusal(edited, light, version->model().prepared.arrangement().solids(), before);
}

// Whether something that is seen hides a place.
bool Viewer3::is_hidden(const Direction3& place) const {
  const std::optional<Pixel> at = camera_.at(place, size_);
  const std::optional<Direction3> surface = at ? surface_at(*at) : std::nullopt;
  const Direction3 eye = camera_.pointer({}, size_).eye;
  return surface && length(*surface - eye) < (1 - kHidden) * length(place - eye);
}

void Viewer3::draw_lights(PictureCanvas& canvas) const {
  const Pointer3 hand = pointer();
  const auto pixel = [&](const Direction3& place) {
    const std::optional<Pixel> at = camera_.at(place, size_);
    return at ? std::optional(within_canvas(*at)) : std::nullopt;
  };
  for (std::uint32_t k = 0; k < shown_->lights.size(); ++k) {
    const std::optional<LightShape3> shape = light_shape(*shown_, k, hand);
    if (!shape) continue;
    LightMark mark{.place = *pixel(shape->place)};
    if (shape->is_spot) {
      mark.axis = pixel(shape->axis);
      mark.left = pixel(shape->left);
      mark.right = pixel(shape->right);
      for (const Direction3& corner : shape->rim)
        if (const auto at = pixel(corner)) mark.rim.push_back(*at);
    }
    LightStyle style{.is_meant = editor_.selected_light() == k, .is_pale = is_hidden(shape->place)};
    if (drag_ == Drag::kNone && hover_light_ && hover_light_->light == k) {
      style.is_meant = true;
      style.touched = hover_light_->part;
    }
    draw_light(canvas, shown_->lights[k], mark, style, unit_);
  }
}

}  // namespace hottel

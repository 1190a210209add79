// What a viewer in space does to lights, and how it draws them.
#include <algorithm>

#include "geometry/space/scene/light_place_problem.h"
#include "geometry/space/scene/moving_lights.h"
#include "viewer/edit/decimals.h"
#include "viewer/edit/space/light_region.h"
#include "viewer/window/lights.h"
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
std::optional<std::uint32_t> Viewer3::light_meant() {
  touch();
  if (hover_light_) return hover_light_->light;
  return hover_ ? std::nullopt : editor_.selected_light();
}

// Tells what was done, or why nothing was.
void Viewer3::say(const std::string& done, const char* nothing) {
  message_ = !done.empty() ? done : !editor_.refusal().empty() ? editor_.refusal() : nothing;
}

std::vector<Rational> Viewer3::rotation_of(std::uint32_t light) const {
  const Vector3& rates = scene()->light_places[light].rotation;
  return {rates.x, rates.y, rates.z};
}

std::string Viewer3::set_light(std::uint32_t light, const Light& values, std::span<const Rational> rotation) {
  return editor_.change_light(light, values, {rotation[0], rotation[1], rotation[2]});
}

bool Viewer3::can_lights_move() const { return has_moving_lights(*scene()); }

std::string Viewer3::show_lights_after(const Rational& seconds) {
  const auto moved = std::make_shared<const Scene3>(scene_after(*scene(), seconds));
  for (std::uint32_t k = 0; k < moved->lights.size(); ++k) {
    if (moved->light_places[k].position == scene()->light_places[k].position) continue;
    if (const std::string problem = place_problem(*moved, k); !problem.empty()) return problem;
  }
  shown_ = moved;
  live_.set(shown_);
  return "";
}

void Viewer3::show_lights_standing() {
  shown_ = told_;
  live_.set(shown_);
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
    LightStyle style = light_style(k, editor_.selected_light(), drag_ == Drag::kNone ? hover_light_ : std::nullopt);
    style.is_pale = is_hidden(shape->place);
    draw_light(canvas, shown_->lights[k], mark, style, unit_);
  }
}

}  // namespace hottel

// What a desk does to lights, and how it draws them.
#include <fmt/format.h>

#include <algorithm>

#include "viewer/edit/light_edits.h"
#include "viewer/edit/material_edits.h"
#include "viewer/picture/palette.h"
#include "viewer/window/plane/desk.h"

namespace hottel {
namespace {

constexpr double kDisc = 5, kHandle = 3.5;  // units
constexpr int kSpin = 30;                   // degrees a second of a light that is set spinning
constexpr Colour kBeam{0.98, 0.86, 0.40, 0.9};

// The colour that a light has, at its brightest; black where it has no power.
Colour colour_of(const Light& light) {
  const double most = to_double(*std::ranges::max_element(light.power.value));
  const auto part = [&](std::size_t c) { return most > 0 ? to_double(light.power.value[c]) / most : 0; };
  return {part(0), part(1), part(2)};
}

}  // namespace

// The light under the mouse; where no edge is there either, the one that is selected.
std::optional<std::uint32_t> Desk2::light_meant() const {
  if (hover_light_) return hover_light_->light;
  return hover_.surface ? std::nullopt : editor_.selected_light();
}

bool Desk2::light_command(std::string_view name) {
  const std::optional<std::uint32_t> light = light_meant();
  if (name == "spin") {
    if (light)
      change_light(*light, name);
    else
      message_ = "no light lies under the mouse, and none is selected";
    return true;
  }
  if (!light || (name != "material" && !is_material_edit(name))) return false;
  name == "material" ? ask_for_light(*light) : change_light(*light, name);
  return true;
}

void Desk2::change_light(std::uint32_t light, std::string_view name) {
  const std::string changed = editor_.change_light(light, [name](Light& values, Rational& rotation) {
    if (name != "spin") return edit_light(values, name);
    if (values.type == LightType::kSpot) rotation = rotation == 0 ? kSpin : 0;
  });
  const Light& now = editor_.scene()->lights[light];
  const Rational& rotation = editor_.scene()->light_places[light].rotation;
  if (changed.empty())
    message_ = name == "spin" ? "a point light has no axis to turn" : "it goes no further";
  else if (!hover_light_)  // what lies under the mouse is told already
    message_ = now.name + ": " + light_text(now, {&rotation, 1});
}

void Desk2::ask_for_light(std::uint32_t light) {
  const Light& now = editor_.scene()->lights[light];
  const Rational& rotation = editor_.scene()->light_places[light].rotation;
  prompt_ = Prompt{.question = now.name,
                   .text = light_text(now, {&rotation, 1}),
                   .answer = [this, light, values = now, turning = rotation](const std::string& text) {
                     Light read = values;
                     Rational read_turning = turning;
                     const std::string problem = read_light(text, read, {&read_turning, 1});
                     if (!problem.empty()) return problem;
                     editor_.change_light(light, [&](Light& changed, Rational& rotation_now) {
                       changed = read;
                       rotation_now = read_turning;
                     });
                     scene_changed();
                     return std::string();
                   }};
}

void Desk2::draw_lights(PictureCanvas& canvas) const {
  const Frame2 frame = camera_.frame(size_);
  const Scene2& scene = *editor_.scene();
  const double arm = pointer().arm;
  for (std::uint32_t k = 0; k < scene.lights.size(); ++k) {
    const LightShape2 shape = light_shape(scene, k, arm);
    const bool is_touched = drag_ == Drag::kNone && hover_light_ && hover_light_->light == k;
    const bool is_meant = is_touched || editor_.selected_light() == k;
    const Pixel at = camera_.at(shape.place, size_);
    if (shape.is_spot && is_meant)
      for (const auto& [end, part, width] : {std::tuple(shape.axis, LightPart2::kAxis, 2.0),
                                             {shape.left, LightPart2::kLeft, 1.2},
                                             {shape.right, LightPart2::kRight, 1.2}}) {
        const bool is_under_mouse = is_touched && hover_light_->part == part;
        canvas.stroke(Mark::kTarget, at, camera_.at(end, size_), kBeam, width * unit_);
        canvas.disc(Mark::kTarget, camera_.at(end, size_), (is_under_mouse ? 1.5 : 1) * kHandle * unit_,
                    palette::kTarget);
      }
    else if (shape.is_spot)
      canvas.stroke(Mark::kTarget, at, camera_.at(light_shape(scene, k, arm / 3).axis, size_), kBeam, 2 * unit_);
    canvas.disc(Mark::kTarget, at, kDisc * unit_, colour_of(scene.lights[k]));
    canvas.circle(Mark::kTarget, at, kDisc * unit_, is_meant ? palette::kTarget : palette::kInk,
                  (is_meant ? 2.5 : 1.5) * unit_);
  }
}

}  // namespace hottel

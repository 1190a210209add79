#include "viewer/window/lights.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "viewer/edit/light_edits.h"
#include "viewer/picture/palette.h"

namespace hottel {
namespace {

constexpr double kDisc = 5, kHandle = 3.5;  // units
constexpr double kPale = 0.35;              // of what is hidden
constexpr Colour kBeam{0.98, 0.86, 0.40, 0.9};

// The colour that a light has, at its brightest; black where it has no power.
Colour colour_of(const Light& light) {
  const double most = to_double(*std::ranges::max_element(light.power.value));
  const auto part = [&](std::size_t c) { return most > 0 ? to_double(light.power.value[c]) / most : 0; };
  return {part(0), part(1), part(2)};
}

void draw_beam(PictureCanvas& canvas, const LightMark& mark, const LightStyle& style, double unit) {
  const double shown = style.is_pale ? kPale : 1;
  for (std::size_t k = 0; k < mark.rim.size(); ++k)
    canvas.stroke(Mark::kTarget, mark.rim[k], mark.rim[(k + 1) % mark.rim.size()], kBeam.with_alpha(kBeam.a * shown),
                  1.2 * unit);
  for (const auto& [end, part, width] : {std::tuple(mark.axis, LightPart::kAxis, 2.0),
                                         {mark.left, LightPart::kLeft, 1.2},
                                         {mark.right, LightPart::kRight, 1.2}}) {
    if (!end) continue;
    canvas.stroke(Mark::kTarget, mark.place, *end, kBeam.with_alpha(kBeam.a * shown), width * unit);
    canvas.disc(Mark::kTarget, *end, (style.touched == part ? 1.5 : 1) * kHandle * unit, palette::kTarget);
  }
}

}  // namespace

Pixel within_canvas(const Pixel& p) {
  constexpr double kFar = 1e6;
  return {std::clamp(p.x, -kFar, kFar), std::clamp(p.y, -kFar, kFar)};
}

void draw_light(PictureCanvas& canvas, const Light& light, const LightMark& mark, const LightStyle& style,
                double unit) {
  const double shown = style.is_pale && !style.is_meant ? kPale : 1;
  if (style.is_meant) {
    draw_beam(canvas, mark, style, unit);
  } else if (mark.axis) {
    const Pixel end{std::lerp(mark.place.x, mark.axis->x, 1.0 / 3), std::lerp(mark.place.y, mark.axis->y, 1.0 / 3)};
    canvas.stroke(Mark::kTarget, mark.place, end, kBeam.with_alpha(kBeam.a * shown), 2 * unit);
  }
  canvas.disc(Mark::kTarget, mark.place, kDisc * unit, colour_of(light).with_alpha(shown));
  const Colour ring = style.is_meant ? palette::kTarget : palette::kInk;
  canvas.circle(Mark::kTarget, mark.place, kDisc * unit, ring.with_alpha(shown), (style.is_meant ? 2.5 : 1.5) * unit);
}

LightStyle light_style(std::uint32_t light, const std::optional<std::uint32_t>& selected,
                       const std::optional<LightHold>& touched) {
  LightStyle style{.is_meant = selected == light};
  if (touched && touched->light == light) style = {.is_meant = true, .touched = touched->part};
  return style;
}

std::string light_line(const Light& light, std::span<const Rational> rotation) {
  return light.name + ": " + light_text(light, rotation);
}

std::string begin_to_move(std::optional<Rational>& time, bool is_dragging, bool can_move) {
  if (is_dragging) return "not while something is dragged";
  if (!can_move) return "no light moves";
  time = 0;
  return "the lights move";
}

std::string why_lights_stand(const Rational& seconds, const std::string& problem) {
  return fmt::format("after {:.4g} s: {}", to_double(seconds), problem);
}

Prompt light_prompt(const Light& light, std::vector<Rational> rotation,
                    const std::function<void(const Light& light, std::span<const Rational> rotation)>& change) {
  return {.question = light.name,
          .text = light_text(light, rotation),
          .answer = [light, rotation = std::move(rotation), change](const std::string& text) {
            Light read = light;
            std::vector<Rational> turning = rotation;
            std::string problem = read_light(text, read, turning);
            if (problem.empty()) change(read, turning);
            return problem;
          }};
}

}  // namespace hottel

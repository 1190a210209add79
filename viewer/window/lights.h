// Lights in a window, in either dimension: how they look, and how their values are asked for.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/light.h"
#include "viewer/edit/light_hold.h"
#include "viewer/picture/canvas.h"
#include "viewer/window/prompt.h"

namespace hottel {

// Units from a light to its handles.
inline constexpr double kLightArm = 60;

// The pixel, or one in that direction so far out that no canvas minds it.
Pixel within_canvas(const Pixel& p);

// Where a light is drawn. What a point light does not have is nothing.
struct LightMark {
  Pixel place{};
  std::optional<Pixel> axis{}, left{}, right{};  // the ends of the axis and of two borders of the beam
  std::vector<Pixel> rim{};                      // of the beam, closed, where it is to be seen
};

// Draws a disc in the colour of the light, and its axis; where it is meant, with the borders of its beam and handles.
// touched: the part under the mouse. pale: it is hidden by something. unit: of sizes, in pixels.
struct LightStyle {
  bool is_meant = false, is_pale = false;
  std::optional<LightPart> touched{};
};
void draw_light(PictureCanvas& canvas, const Light& light, const LightMark& mark, const LightStyle& style, double unit);

// How a light looks: meant, where it is the selected one or what is touched is of it.
LightStyle light_style(std::uint32_t light, const std::optional<std::uint32_t>& selected,
                       const std::optional<LightHold>& touched);

// In one line: "torch: power 5; focus 20; falloff 0; rotation 0 0 30".
std::string light_line(const Light& light, std::span<const Rational> rotation);

// Lets lights begin to move, at the time 0, where nothing is dragged and some light can. Returns what is to be said.
std::string begin_to_move(std::optional<Rational>& time, bool is_dragging, bool can_move);

// What is to be said where lights come to stand, so long after they began to move.
std::string why_lights_stand(const Rational& seconds, const std::string& problem);

// Asks for the values of a light and the rotation of its axis. change: what to do with those that are read.
Prompt light_prompt(const Light& light, std::vector<Rational> rotation,
                    const std::function<void(const Light& light, std::span<const Rational> rotation)>& change);

}  // namespace hottel

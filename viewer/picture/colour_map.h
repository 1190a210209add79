// Values as colours, in an order that the eye sees.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "viewer/picture/canvas.h"
#include "viewer/picture/picture_options.h"

namespace hottel {

// Returns the sRGB value of a linear intensity in [0, 1] (IEC 61966-2-1), and back.
double srgb_from_linear(double linear);
double linear_from_srgb(double encoded);

// Returns 255 times the sRGB value of a linear intensity, rounded: the level of a screen. 0 below 0 and for NaN, 255
// above 1. COST: a few ns.
std::uint8_t srgb_level(double linear);

// A colour in OKLab (Björn Ottosson, "A perceptual color space for image processing", 2020), in polar form.
struct OklabPolar {
  double lightness;  // 0 black, 1 white
  double chroma;
  double hue;  // degrees
};

// Returns the colour on a screen; components outside [0, 1] are cut off.
Colour colour_of(const OklabPolar& colour);

// Returns the lightness of a colour as OKLab sees it, the opacity left out.
double lightness(const Colour& colour);

// Returns the colour of a position in [0, 1], positions outside clamped: indigo, violet, red, orange, straw. It is our
// own: lightness rises evenly, hue turns one way, and every colour lies inside sRGB without cutting.
//
//   (1) lightness(map_colour(t)) is linear in t and increases
//   (2) readable for colour-blind eyes and in grey print, since (1) alone carries the order
Colour map_colour(double position);

// Returns the colour of a position in [-1, 1], positions outside clamped: blue, through paper at 0, to red.
//
//   (1) lightness(signed_map_colour(t)) is linear in |t| and falls: -t and t are equally dark, the hue tells the sign
Colour signed_map_colour(double position);

// Returns the colour of a value on a scale: map_colour of its position, or signed_map_colour where colours part at 0.
// On a scale that has_zero what is not above 0 has a colour of its own, pale and almost without hue: it is no small
// value.
Colour scale_colour(const ColourScale& scale, double value);

// Returns the values as labels with just the digits that tell them apart: "0", "0.05", "0.1", or "1e-06".
std::vector<std::string> tick_labels(const std::vector<double>& ticks);

// What a legend shows beside its scale: other colours than those of scale_colour, and a value that is marked; one
// beside the scale is marked at its end.
struct LegendMarks {
  std::function<Colour(double value)> colour{};
  std::optional<double> marked{};
};

// Draws a bar with the colours of a scale, labels beneath it and the title above, its top left corner at `corner`;
// where a scale has_zero, its colour stands apart at the left, and an end that is cut is an arrow. `unit` is the size
// of everything: the height of letters is about 11 units. Returns the width that the bar, its labels and title take, at
// most 1.6 bars: a longer title is set smaller.
double draw_legend(PictureCanvas& canvas, const ColourScale& scale, const std::string& title, Pixel corner,
                   double bar_width, double unit, const LegendMarks& marks = {});

}  // namespace hottel

// What drawings are drawn on: a picture of pixels, y downwards, later calls over earlier ones.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "viewer/picture/raster.h"

namespace hottel {

// A place in the picture: (0, 0) is the top left corner, (width, height) the bottom right one.
struct Pixel {
  double x = 0, y = 0;
  friend bool operator==(const Pixel&, const Pixel&) = default;
};

// sRGB as a screen takes it, each of r, g, b and the opacity a in [0, 1].
struct Colour {
  double r = 0, g = 0, b = 0, a = 1;

  constexpr Colour with_alpha(double alpha) const { return {r, g, b, alpha}; }
  friend bool operator==(const Colour&, const Colour&) = default;
};

// Returns a colour as a pixel of a raster: each of its levels rounded, halves up.
inline std::uint32_t pixel_of(const Colour& c) {
  const auto level = [](double v) {
    const double scaled = 255 * std::clamp(v, 0.0, 1.0);
    const auto whole = static_cast<std::uint32_t>(scaled);
    return whole + (scaled - whole >= 0.5 ? 1 : 0);
  };
  return level(c.a) << 24 | level(c.r * c.a) << 16 | level(c.g * c.a) << 8 | level(c.b * c.a);
}

// The same of the levels of r, g and b, opaque.
inline std::uint32_t pixel_of_levels(const std::array<std::uint8_t, 3>& level) {
  return 0xFF000000u | std::uint32_t{level[0]} << 16 | std::uint32_t{level[1]} << 8 | level[2];
}

// What a stroke or a fill stands for. A canvas for the eye ignores it; a recording canvas counts by it.
enum class Mark : unsigned char {
  kPaper,
  kFloor,
  kSolid,
  kHatch,
  kLight,   // what is seen from the eye
  kStripe,  // the value of a face
  kEdge,    // the centre line of a wall
  kEmitter,
  kTarget,  // a highlighted edge
  kRay,
  kEye,
  kCritical,  // a critical point
  kLegend,
  kScaleBar,
  kTitle,
  kLabel,
  kAxis,   // of a plot, its grid and numbers
  kCurve,  // of a plot
  kPoint,  // on a curve
};

// A colour at a part of the way between two places.
struct ColourStop {
  double share = 0;  // 0 to 1
  Colour colour{};
  friend bool operator==(const ColourStop&, const ColourStop&) = default;
};

enum class TextAnchor : unsigned char { kLeft, kCentre, kRight };
enum class TextWeight : unsigned char { kRegular, kBold };

// How a text looks, and which of its points lies where it is asked for.
struct TextStyle {
  double size = 16;  // of the font, in pixels
  Colour colour{};
  TextAnchor anchor = TextAnchor::kLeft;
  TextWeight weight = TextWeight::kRegular;
};

// A sheet of width() by height() pixels. What lies outside of it is not seen, and is no error.
//
//   (1) later marks cover earlier ones; colours with a < 1 let them shine through
//   (2) the mark of a call changes nothing that is seen
// REQUIRES of all calls: finite coordinates and sizes. Ends and joints of strokes are round.
class PictureCanvas {
 public:
  virtual ~PictureCanvas() = default;

  // The size of the picture in pixels.
  virtual double width() const = 0;
  virtual double height() const = 0;

  // A straight line, line_width pixels wide.
  virtual void stroke(Mark mark, Pixel from, Pixel to, Colour colour, double line_width) = 0;
  // The inside of a closed polygon; where it winds about itself more than once it is inside.
  virtual void fill(Mark mark, std::span<const Pixel> polygon, Colour colour) = 0;
  // What is inside one of several polygons that go around in one sense, filled at once: where two of them share a side
  // nothing shines through.
  virtual void fill_all(Mark mark, std::span<const std::vector<Pixel>> polygons, Colour colour) = 0;
  // The inside of a polygon, as fill() has it, in colours that run from one place to another, equal on each line across
  // that way: linear between stops, and beyond them that of the nearest one. REQUIRES stops, ascending.
  virtual void fill_along(Mark mark, std::span<const Pixel> polygon, Pixel from, Pixel to,
                          std::span<const ColourStop> stops) = 0;
  // A filled circle; a circle of which only the line is drawn, half of its width inside the radius.
  virtual void disc(Mark mark, Pixel centre, double radius, Colour colour) = 0;
  virtual void circle(Mark mark, Pixel centre, double radius, Colour colour, double line_width) = 0;
  // One line. at: the anchor on the base line. Bytes that are not UTF-8 are shown as question marks.
  virtual void text(Mark mark, Pixel at, std::string_view text, const TextStyle& style) = 0;
  // Stretched over the rectangle; smooth: blended between pixels, else each pixel a rectangle of its own; nothing
  // that is smaller than a thousandth of a pixel. REQUIRES a raster of width * height pixels.
  virtual void image(Mark mark, Pixel top_left, Pixel bottom_right, const Raster& raster, bool smooth) = 0;

  // Until unclip() nothing is drawn outside the polygon. One clip at a time.
  virtual void clip(std::span<const Pixel> polygon) = 0;
  // Everything is drawn again.
  virtual void unclip() = 0;

  // What is drawn until end_layer() comes onto the sheet then, as far as it lies inside one of the polygons, which go
  // around in one sense, and inside the clip where there is one. One layer at a time, and no clip in it.
  virtual void begin_layer() = 0;
  virtual void end_layer(std::span<const std::vector<Pixel>> inside) = 0;

  // How wide text() draws, in pixels.
  virtual double text_width(std::string_view text, const TextStyle& style) const = 0;

  // An upright rectangle, as a polygon of four corners.
  void fill_rectangle(Mark mark, Pixel top_left, Pixel bottom_right, Colour colour) {
    const Pixel corners[] = {top_left, {bottom_right.x, top_left.y}, bottom_right, {top_left.x, bottom_right.y}};
    fill(mark, corners, colour);
  }
};

}  // namespace hottel

// What is asked of a picture: format, size, how light becomes colours, and which values have which colours.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace hottel {

// What a picture is written as: pixels, or shapes that stay sharp at any size.
enum class PictureFormat : unsigned char { kPng, kSvg, kPdf };

// Returns the format that the ending of a file name asks for (".png", ".svg", ".pdf"), or nothing.
std::optional<PictureFormat> picture_format(std::string_view file_name);

// The largest width or height of a picture, and the least width of a drawing.
inline constexpr std::uint32_t kMaxPictureSide = 16384;
inline constexpr std::uint32_t kMinPictureWidth = 200;

// How light becomes colours (tone_curve.h).
enum class Tone : unsigned char { kLinear, kReinhard, kLog, kMax };

// The curve of light where none is asked for. In the plane light between faces spans decades, up to the lamps; a camera
// in space sees lit surfaces, and tells more between them.
inline constexpr Tone kUsualTone2 = Tone::kLog, kUsualTone3 = Tone::kReinhard;

// "linear", "reinhard", "log", "max"; and back, nothing for other names.
const char* to_string(Tone tone);
std::optional<Tone> tone_of(std::string_view name);

// How values become positions, or, of what has a sign, how far they are from 0.
struct ColourScale {
  double lower = 0, upper = 1;
  bool logarithmic = false;
  bool about_zero = false;  // colours part at 0, as far on both sides; excludes logarithmic
  bool has_zero = false;  // logarithmic: some values are 0, which have a colour of their own, and a place in the legend
  bool cuts_lower = false, cuts_upper = false;  // some values lie beyond that end: the legend has an arrow there

  // Returns where the value lies between lower and upper, clamped to [0, 1]; 0 of every value where they are equal.
  // REQUIRES lower <= upper, both finite; logarithmic: lower > 0. A value <= 0 on a logarithmic scale has position 0.
  double position(double value) const;

  // Returns the value at a position from 0 to 1: position(value(t)) is t but for rounding, where lower < upper.
  double value(double position) const;

  // Returns the value over the largest distance of lower and upper from 0, clamped to [-1, 1]; 0 when both are 0.
  // REQUIRES finite ends.
  double signed_position(double value) const;

  // Returns the values for labels: multiples of 1, 2 or 5 times a power of ten inside [lower, upper], ascending, at
  // most limit of them; logarithmic: whole decades, every few of them when there are many, or the linear ones when
  // there is less than one decade.
  std::vector<double> ticks(int limit) const;
};

}  // namespace hottel

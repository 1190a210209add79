#include "viewer/picture/colour_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

#include "kernel/plain_functions.h"
#include "kernel/support/failure.h"
#include "viewer/picture/palette.h"

namespace hottel {
namespace {

// The stations of the map: hue and chroma, at even steps of the position.
constexpr std::array<OklabPolar, 6> kStations{{
    {0.40, 0.165, 272},
    {0.496, 0.185, 305},
    {0.592, 0.205, 355},
    {0.688, 0.175, 395},
    {0.784, 0.160, 428},
    {0.88, 0.165, 456},
}};

// The map of what has a sign: from paper to blue below 0 and to red above. The hues of the ends hold all the way.
constexpr OklabPolar kMiddle{0.95, 0, 0}, kBelowZero{0.45, 0.15, 262}, kAboveZero{0.45, 0.15, 30};

OklabPolar between(const OklabPolar& a, const OklabPolar& b, double t) {
  return {std::lerp(a.lightness, b.lightness, t), std::lerp(a.chroma, b.chroma, t), std::lerp(a.hue, b.hue, t)};
}

// Returns the largest of 1, 2, 5 times a power of ten steps that gives at most limit multiples in the range.
double nice_step(double lower, double upper, int limit) {
  double power = same_bits::pow(10, std::floor(same_bits::log10((upper - lower) / limit)));
  for (;; power *= 10)
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double step = factor * power;
      if (std::floor(upper / step + 1e-9) - std::ceil(lower / step - 1e-9) + 1 <= limit) return step;
    }
}

}  // namespace

double srgb_from_linear(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * same_bits::pow(linear, 1 / 2.4) - 0.055;
}

namespace {

// Where the levels of a screen begin, and for each short interval of doubles the level that it begins in.
class ScreenLevels {
 public:
  ScreenLevels() {
    begin_[0] = 0;
    for (int level = 1; level < 256; ++level) {  // the least double of that level, by bisection of their bits
      std::uint64_t below = 0, at = std::bit_cast<std::uint64_t>(1.0);
      while (at - below > 1) {
        const std::uint64_t middle = below + (at - below) / 2;
        (std::lround(255 * srgb_from_linear(std::bit_cast<double>(middle))) >= level ? at : below) = middle;
      }
      begin_[level] = std::bit_cast<double>(at);
    }
    begin_[256] = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < first_.size(); ++k) {
      const double least = std::bit_cast<double>((k + kFirstBits) << kShift);
      first_[k] = static_cast<std::uint8_t>(std::upper_bound(begin_.begin(), begin_.end(), least) - begin_.begin() - 1);
    }
  }

  std::uint8_t operator()(double linear) const {
    if (!(linear >= begin_[1])) return 0;
    if (linear >= 1) return 255;
    std::uint8_t level = first_[(std::bit_cast<std::uint64_t>(linear) >> kShift) - kFirstBits];
    while (linear >= begin_[level + 1]) ++level;
    return level;
  }

 private:
  static constexpr int kShift = 52 - 8;  // 256 intervals between a number and its double
  static constexpr std::uint64_t kFirstBits = std::bit_cast<std::uint64_t>(0x1p-13) >> kShift;  // below level 1
  std::array<double, 257> begin_;
  std::array<std::uint8_t, 13 * 256> first_;
};

}  // namespace

std::uint8_t srgb_level(double linear) {
  static const ScreenLevels levels;
  return levels(linear);
}

double linear_from_srgb(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : same_bits::pow((encoded + 0.055) / 1.055, 2.4);
}

Colour colour_of(const OklabPolar& colour) {
  const double angle = colour.hue * std::numbers::pi / 180;
  const double a = colour.chroma * same_bits::cos(angle), b = colour.chroma * same_bits::sin(angle),
               l = colour.lightness;
  const auto cube = [](double v) { return v * v * v; };
  const double cone_l = cube(l + 0.3963377774 * a + 0.2158037573 * b);
  const double cone_m = cube(l - 0.1055613458 * a - 0.0638541728 * b);
  const double cone_s = cube(l - 0.0894841775 * a - 1.2914855480 * b);
  const auto encode = [](double v) { return srgb_from_linear(std::clamp(v, 0.0, 1.0)); };
  return {encode(4.0767416621 * cone_l - 3.3077115913 * cone_m + 0.2309699292 * cone_s),
          encode(-1.2684380046 * cone_l + 2.6097574011 * cone_m - 0.3413193965 * cone_s),
          encode(-0.0041960863 * cone_l - 0.7034186147 * cone_m + 1.7076147010 * cone_s)};
}

double lightness(const Colour& c) {
  const double r = linear_from_srgb(c.r), g = linear_from_srgb(c.g), b = linear_from_srgb(c.b);
  return 0.2104542553 * std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b) +
         0.7936177850 * std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b) -
         0.0040720468 * std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
}

Colour map_colour(double position) {
  const double t = std::clamp(position, 0.0, 1.0) * (kStations.size() - 1);
  const std::size_t k = std::min(static_cast<std::size_t>(t), kStations.size() - 2);
  return colour_of(between(kStations[k], kStations[k + 1], t - static_cast<double>(k)));
}

double ColourScale::position(double value) const {
  HOTTEL_REQUIRE(lower <= upper && (!logarithmic || lower > 0));
  if (!(value > lower) || !(lower < upper)) return 0;
  if (value >= upper) return 1;
  if (logarithmic) return std::clamp(same_bits::log(value / lower) / same_bits::log(upper / lower), 0.0, 1.0);
  const double span = upper / 2 - lower / 2;  // halves: the difference of two doubles may overflow
  return std::clamp((value / 2 - lower / 2) / span, 0.0, 1.0);
}

double ColourScale::value(double position) const {
  return logarithmic ? lower * same_bits::pow(upper / lower, position) : std::lerp(lower, upper, position);
}

Colour signed_map_colour(double position) {
  const double t = std::clamp(position, -1.0, 1.0);
  const OklabPolar& end = t < 0 ? kBelowZero : kAboveZero;
  return colour_of(between({kMiddle.lightness, kMiddle.chroma, end.hue}, end, std::abs(t)));
}

Colour scale_colour(const ColourScale& scale, double value) {
  if (scale.has_zero && !(value > 0)) return palette::kZero;
  return scale.about_zero ? signed_map_colour(scale.signed_position(value)) : map_colour(scale.position(value));
}

double ColourScale::signed_position(double value) const {
  const double most = std::max(std::abs(lower), std::abs(upper));
  return most > 0 ? std::clamp(value / most, -1.0, 1.0) : 0;
}

std::vector<double> ColourScale::ticks(int limit) const {
  if (!(lower < upper) || limit < 2) return {lower};
  if (logarithmic) {
    const int first = static_cast<int>(std::ceil(same_bits::log10(lower) - 1e-9));
    const int last = static_cast<int>(std::floor(same_bits::log10(upper) + 1e-9));
    if (last > first) {
      const int every = std::max(1, (last - first + limit) / limit);
      std::vector<double> decades;
      for (int k = last; k >= first; k -= every) decades.push_back(same_bits::pow(10, k));
      std::reverse(decades.begin(), decades.end());
      return decades;
    }
  }
  const double step = nice_step(lower, upper, limit);
  if (!std::isfinite(step) || step <= 0 || std::max(std::abs(lower), std::abs(upper)) / step > 1e12)
    return {lower, upper};
  std::vector<double> found;
  const auto last = static_cast<long long>(std::floor(upper / step + 1e-9));
  for (auto k = static_cast<long long>(std::ceil(lower / step - 1e-9)); k <= last; ++k)
    found.push_back(k == 0 ? 0.0 : static_cast<double>(k) * step);
  return found;
}

std::vector<std::string> tick_labels(const std::vector<double>& ticks) {
  std::vector<std::string> labels;
  for (const double tick : ticks) labels.push_back(fmt::format("{:.6g}", tick));
  return labels;
}

namespace {

// A bar and its room: from left to right, and beneath each other.
struct BarPlace {
  double left, right, top, bottom;
  double wide() const { return right - left; }
};

// Apart, at the left of a shorter bar.
void draw_zero(PictureCanvas& canvas, const TextStyle& small, double unit, BarPlace& bar) {
  const double swatch = 16 * unit, gap = 8 * unit;
  canvas.fill_rectangle(Mark::kLegend, {bar.left, bar.top}, {bar.left + swatch, bar.bottom}, palette::kZero);
  canvas.text(Mark::kLegend, {bar.left + swatch / 2, bar.bottom + 19 * unit}, "0", small);
  bar.left += swatch + gap;
}

// In place of an end that is cut, in its colour.
void draw_arrows(PictureCanvas& canvas, const ColourScale& scale, BarPlace& bar) {
  const double middle = (bar.top + bar.bottom) / 2, deep = bar.bottom - bar.top;
  const auto draw = [&](double tip, double base, double value) {
    const Pixel corners[] = {{tip, middle}, {base, bar.top}, {base, bar.bottom}};
    canvas.fill(Mark::kLegend, corners, scale_colour(scale, value));
  };
  if (scale.cuts_lower) draw(bar.left, bar.left + deep, scale.lower);
  if (scale.cuts_upper) draw(bar.right, bar.right - deep, scale.upper);
  bar.left += scale.cuts_lower ? deep : 0;
  bar.right -= scale.cuts_upper ? deep : 0;
}

void draw_shades(PictureCanvas& canvas, const ColourScale& scale, const LegendMarks& marks, const BarPlace& bar) {
  constexpr std::uint32_t kShades = 256;
  Raster shades(kShades, 1);
  for (std::uint32_t k = 0; k < kShades; ++k)
    shades.pixels[k] = pixel_of(marks.colour       ? marks.colour(scale.value((k + 0.5) / kShades))
                                : scale.about_zero ? scale_colour(scale, scale.value((k + 0.5) / kShades))
                                                   : map_colour((k + 0.5) / kShades));
  canvas.image(Mark::kLegend, {bar.left, bar.top}, {bar.right, bar.bottom}, shades, true);
}

// A line across the bar, paper beneath ink, so that it is seen on all colours.
void draw_marked(PictureCanvas& canvas, double x, const BarPlace& bar, double unit) {
  const double beyond = 3 * unit;
  for (const auto& [colour, width] : {std::pair(palette::kPaper, 4.0), {palette::kInk, 1.8}})
    canvas.stroke(Mark::kLegend, {x, bar.top - beyond}, {x, bar.bottom + beyond}, colour, width * unit);
}

// Returns where the last label ends.
double draw_ticks(PictureCanvas& canvas, const ColourScale& scale, const TextStyle& small, double unit,
                  const BarPlace& bar) {
  double end = bar.right;
  const std::vector<double> ticks = scale.ticks(std::max(2, static_cast<int>(bar.wide() / (48 * unit))));
  const std::vector<std::string> labels = tick_labels(ticks);
  for (std::size_t k = 0; k < ticks.size(); ++k) {
    const double x = bar.left + bar.wide() * scale.position(ticks[k]);
    canvas.stroke(Mark::kLegend, {x, bar.bottom}, {x, bar.bottom + 4 * unit}, palette::kSoftInk, unit);
    // A label at the very left or right stays within the bar, so that the bar lines up with its neighbours.
    const double half = canvas.text_width(labels[k], small) / 2;
    const double centre = std::clamp(x, bar.left + half, std::max(bar.left + half, bar.right - half));
    canvas.text(Mark::kLegend, {centre, bar.bottom + 19 * unit}, labels[k], small);
    end = std::max(end, centre + half);
  }
  return end;
}

}  // namespace

double draw_legend(PictureCanvas& canvas, const ColourScale& scale, const std::string& title, Pixel corner,
                   double bar_width, double unit, const LegendMarks& marks) {
  TextStyle heading{.size = 17 * unit, .colour = palette::kInk};
  const TextStyle small{.size = 14 * unit, .colour = palette::kSoftInk, .anchor = TextAnchor::kCentre};
  const double room = std::max(bar_width, std::min(1.6 * bar_width, canvas.width() - corner.x - 4 * unit));
  heading.size *= std::min(1.0, room / std::max(1.0, canvas.text_width(title, heading)));
  canvas.text(Mark::kLegend, {corner.x, corner.y + 13 * unit}, title, heading);
  BarPlace bar{corner.x, corner.x + bar_width, corner.y + 24 * unit, corner.y + 38 * unit};
  const double wide = std::max(bar_width, canvas.text_width(title, heading));
  if (scale.has_zero) draw_zero(canvas, small, unit, bar);
  draw_arrows(canvas, scale, bar);
  draw_shades(canvas, scale, marks, bar);
  const double end = draw_ticks(canvas, scale, small, unit, bar);
  if (marks.marked) draw_marked(canvas, bar.left + bar.wide() * scale.position(*marks.marked), bar, unit);
  return std::max(wide, end - corner.x);
}

}  // namespace hottel

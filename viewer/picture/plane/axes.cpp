#include "viewer/picture/plane/axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "viewer/picture/colour_map.h"
#include "viewer/picture/palette.h"

namespace hottel {
namespace {

constexpr double kTick = 6, kLetters = 14, kPen = 1.2;
constexpr double kBetweenTicks = 90;  // units, at least

constexpr double kMostDigits = 1e12;  // of a coordinate over what lies between two ticks

// Ticks at round coordinates between two, and what they are called: with as many decimals as tell them apart.
struct Ticks {
  std::vector<double> at;
  std::vector<std::string> labels;

  Ticks(double lower, double upper, double units) {
    if (!std::isfinite(lower) || !std::isfinite(upper) || !(lower < upper)) return;
    if (std::max(std::abs(lower), std::abs(upper)) > kMostDigits * (upper - lower)) return;
    const int most = static_cast<int>(std::clamp(units / kBetweenTicks, 2.0, 20.0));
    at = ColourScale{.lower = lower, .upper = upper}.ticks(most);
    if (at.size() < 2) return;
    const double exponent = std::floor(std::log10(at[1] - at[0]) + 1e-9);
    const bool is_plain = exponent > -7 && std::abs(at.back()) < 1e12 && std::abs(at.front()) < 1e12;
    for (const double value : at)
      labels.push_back(is_plain ? fmt::format("{:.{}f}", value, static_cast<int>(std::max(0.0, -exponent)))
                                : fmt::format("{:.12g}", value));
  }
};

}  // namespace

void draw_axes_2(PictureCanvas& canvas, const Frame2& frame, double unit, const std::string& length_unit) {
  const Pixel from = frame.top_left(), to = frame.bottom_right();
  const Pixel corners[] = {from, {to.x, from.y}, to, {from.x, to.y}};
  for (std::size_t k = 0; k < 4; ++k)
    canvas.stroke(Mark::kAxis, corners[k], corners[(k + 1) % 4], palette::kInk, kPen * unit);
  const std::array<double, 2> lower = frame.place({from.x, to.y}), upper = frame.place({to.x, from.y});
  TextStyle style{.size = kLetters * unit, .colour = palette::kSoftInk, .anchor = TextAnchor::kCentre};

  const Ticks x(lower[0], upper[0], (to.x - from.x) / unit);
  double end = from.x;
  for (std::size_t k = 0; k < x.labels.size(); ++k) {
    const double at = frame.at(std::array{x.at[k], lower[1]}).x;
    canvas.stroke(Mark::kAxis, {at, to.y}, {at, to.y + kTick * unit}, palette::kInk, kPen * unit);
    canvas.text(Mark::kAxis, {at, to.y + (kTick + kLetters) * unit}, x.labels[k], style);
    end = at + canvas.text_width(x.labels[k], style) / 2;
  }
  style.anchor = TextAnchor::kLeft;
  if (!x.labels.empty())
    canvas.text(Mark::kAxis, {end + 6 * unit, to.y + (kTick + kLetters) * unit}, length_unit, style);

  style.anchor = TextAnchor::kRight;
  const Ticks y(lower[1], upper[1], (to.y - from.y) / unit);
  const double room = from.x - (kTick + 6) * unit;
  for (const std::string& label : y.labels)
    if (const double wide = canvas.text_width(label, style); wide > room && room > 0) style.size *= room / wide;
  for (std::size_t k = 0; k < y.labels.size(); ++k) {
    const double at = frame.at(std::array{lower[0], y.at[k]}).y;
    canvas.stroke(Mark::kAxis, {from.x - kTick * unit, at}, {from.x, at}, palette::kInk, kPen * unit);
    canvas.text(Mark::kAxis, {from.x - (kTick + 3) * unit, at + style.size / 3}, y.labels[k], style);
  }
}

}  // namespace hottel

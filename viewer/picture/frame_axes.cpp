#include "viewer/picture/frame_axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernel/plain_functions.h"
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
    const double exponent = std::floor(same_bits::log10(at[1] - at[0]) + 1e-9);
    const bool is_plain = exponent > -7 && std::abs(at.back()) < 1e12 && std::abs(at.front()) < 1e12;
    for (const double value : at)
      labels.push_back(is_plain ? fmt::format("{:.{}f}", value, static_cast<int>(std::max(0.0, -exponent)))
                                : fmt::format("{:.12g}", value));
  }
};

void draw_lower(PictureCanvas& canvas, const AxesFrame& frame, double unit) {
  const Pixel from = frame.top_left, to = frame.bottom_right;
  TextStyle style{.size = kLetters * unit, .colour = palette::kSoftInk, .anchor = TextAnchor::kCentre};
  const Ticks x(std::min(frame.left, frame.right), std::max(frame.left, frame.right), (to.x - from.x) / unit);
  double end = from.x;
  for (std::size_t k = 0; k < x.labels.size(); ++k) {
    const double at = std::lerp(from.x, to.x, (x.at[k] - frame.left) / (frame.right - frame.left));
    canvas.stroke(Mark::kAxis, {at, to.y}, {at, to.y + kTick * unit}, palette::kInk, kPen * unit);
    canvas.text(Mark::kAxis, {at, to.y + (kTick + kLetters) * unit}, x.labels[k], style);
    end = std::max(end, at + canvas.text_width(x.labels[k], style) / 2);
  }
  style.anchor = TextAnchor::kLeft;
  if (!x.labels.empty())
    canvas.text(Mark::kAxis, {end + 6 * unit, to.y + (kTick + kLetters) * unit}, frame.along, style);
}

void draw_left(PictureCanvas& canvas, const AxesFrame& frame, double unit) {
  const Pixel from = frame.top_left, to = frame.bottom_right;
  TextStyle style{.size = kLetters * unit, .colour = palette::kSoftInk, .anchor = TextAnchor::kRight};
  const Ticks y(std::min(frame.lower, frame.upper), std::max(frame.lower, frame.upper), (to.y - from.y) / unit);
  const double room = from.x - (kTick + 6) * unit;
  for (const std::string& label : y.labels)
    if (const double wide = canvas.text_width(label, style); wide > room && room > 0) style.size *= room / wide;
  for (std::size_t k = 0; k < y.labels.size(); ++k) {
    const double at = std::lerp(to.y, from.y, (y.at[k] - frame.lower) / (frame.upper - frame.lower));
    canvas.stroke(Mark::kAxis, {from.x - kTick * unit, at}, {from.x, at}, palette::kInk, kPen * unit);
    canvas.text(Mark::kAxis, {from.x - (kTick + 3) * unit, at + style.size / 3}, y.labels[k], style);
  }
  if (!y.labels.empty() && !frame.up.empty())
    canvas.text(Mark::kAxis, {from.x - (kTick + 3) * unit, from.y - kLetters * unit / 2}, frame.up, style);
}

}  // namespace

void draw_frame_axes(PictureCanvas& canvas, const AxesFrame& frame, double unit) {
  const Pixel from = frame.top_left, to = frame.bottom_right;
  const Pixel corners[] = {from, {to.x, from.y}, to, {from.x, to.y}};
  for (std::size_t k = 0; k < 4; ++k)
    canvas.stroke(Mark::kAxis, corners[k], corners[(k + 1) % 4], palette::kInk, kPen * unit);
  draw_lower(canvas, frame, unit);
  draw_left(canvas, frame, unit);
}

}  // namespace hottel

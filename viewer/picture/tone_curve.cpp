#include "viewer/picture/tone_curve.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <vector>

#include "kernel/plain_functions.h"
#include "kernel/support/failure.h"
#include "viewer/picture/colour_map.h"

namespace hottel {
namespace {

// The words of Tone, in its order.
constexpr std::array<const char*, 4> kTones{"linear", "reinhard", "log", "max"};

constexpr double kMiddleLight = 0.25, kLogSteepness = 2;

std::array<double, 3> rgb(std::span<const double> value) {
  return value.size() < 3 ? std::array{value[0], value[0], value[0]} : std::array{value[0], value[1], value[2]};
}

double luminance(const std::array<double, 3>& c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; }

double exact_log(double y) { return same_bits::log1p(y); }

// log(1 + y) for y >= 0, off by less than 10^-6.
class NearLog {
 public:
  NearLog() {
    for (std::size_t k = 0; k < kSteps; ++k) {
      log_[k] = same_bits::log1p(static_cast<double>(k) / kSteps);
      slope_[k] = (same_bits::log1p(static_cast<double>(k + 1) / kSteps) - log_[k]) * kSteps;
    }
  }
  double operator()(double y) const {
    const auto bits = std::bit_cast<std::uint64_t>(1 + y);
    const auto exponent = static_cast<int>(bits >> 52) - 1023;
    const double part = std::bit_cast<double>((bits & kFraction) | std::bit_cast<std::uint64_t>(1.0)) - 1;
    const auto k = static_cast<std::size_t>(part * kSteps);
    return exponent * std::numbers::ln2 + log_[k] + slope_[k] * (part - static_cast<double>(k) / kSteps);
  }

 private:
  static constexpr std::size_t kSteps = 512;
  static constexpr std::uint64_t kFraction = (std::uint64_t{1} << 52) - 1;
  std::array<double, kSteps> log_{}, slope_{};
};

// srgb_level for 0 <= light <= 1, off by one at most: so steep is it nowhere that a step of the table is a level.
class NearLevels {
 public:
  NearLevels() {
    for (std::size_t k = 0; k <= kSteps; ++k) level_[k] = srgb_level(static_cast<double>(k) / kSteps);
  }
  std::uint8_t operator()(double light) const { return level_[static_cast<std::size_t>(light * kSteps + 0.5)]; }

 private:
  static constexpr std::size_t kSteps = 4096;
  std::array<std::uint8_t, kSteps + 1> level_{};
};

std::array<std::uint8_t, 3> levels_of(const std::array<double, 3>& c) {
  const std::uint8_t red = srgb_level(c[0]);
  return {red, c[1] == c[0] ? red : srgb_level(c[1]), c[2] == c[0] ? red : srgb_level(c[2])};
}

}  // namespace

const char* to_string(Tone tone) { return kTones[static_cast<std::size_t>(tone)]; }

std::optional<Tone> tone_of(std::string_view name) {
  for (std::size_t k = 0; k < kTones.size(); ++k)
    if (name == kTones[k]) return static_cast<Tone>(k);
  return std::nullopt;
}

ToneCurve::ToneCurve(Tone tone, double exposure, std::span<const double> values, std::size_t channels) : tone_(tone) {
  HOTTEL_REQUIRE(channels > 0 && values.size() % channels == 0 && exposure > 0);
  double largest = 0, brightest = 0, sum_of_logs = 0, lit = 0;
  for (std::size_t k = 0; k < values.size(); k += channels) {
    const std::span<const double> value = values.subspan(k, channels);
    if (std::isnan(value[0])) continue;
    largest = std::max(largest, channels == 2 ? value[0] : *std::max_element(value.begin(), value.end()));
    const double y = luminance(rgb(value));
    if (!(y > 0)) continue;
    brightest = std::max(brightest, y);
    sum_of_logs += same_bits::log(y);
    ++lit;
  }
  const double middle = lit > 0 ? same_bits::exp(sum_of_logs / lit) : 1;
  switch (tone) {
    case Tone::kLinear:
      scale_ = exposure;
      break;
    case Tone::kMax:
      scale_ = largest > 0 ? exposure / largest : exposure;
      break;
    case Tone::kReinhard:
      scale_ = kMiddleLight * exposure / middle;
      break;
    case Tone::kLog:
      scale_ = kLogSteepness * exposure / middle;
      break;
  }
  white_ = lit > 0 ? brightest * scale_ : 1;
  log_white_ = same_bits::log1p(white_);
}

template <class Log>
double ToneCurve::curve(double y, const Log& log_of_1_and) const {
  if (tone_ == Tone::kReinhard) return y * (1 + y / (white_ * white_)) / (1 + y);
  return log_of_1_and(y) / log_white_;
}

template <class Log>
std::array<double, 3> ToneCurve::linear(std::span<const double> value, const Log& log_of_1_and) const {
  std::array<double, 3> c = rgb(value);
  for (double& channel : c) channel *= scale_;
  if (tone_ == Tone::kReinhard || tone_ == Tone::kLog) {
    const double y = luminance(c);
    if (!(y > 0)) return {};
    const double shown = std::min(curve(y, log_of_1_and), 1.0);
    for (double& channel : c) channel *= shown / y;
    const double top = *std::max_element(c.begin(), c.end());
    if (top > 1 && top > shown) {
      const double mix = (1 - shown) / (top - shown);
      for (double& channel : c) channel = shown + mix * (channel - shown);
    }
  }
  for (double& channel : c) channel = std::clamp(channel, 0.0, 1.0);
  return c;
}

Colour ToneCurve::operator()(std::span<const double> value) const {
  const std::array<double, 3> c = linear(value, exact_log);
  return {srgb_from_linear(c[0]), srgb_from_linear(c[1]), srgb_from_linear(c[2])};
}

std::array<std::uint8_t, 3> ToneCurve::levels(std::span<const double> value) const {
  return levels_of(linear(value, exact_log));
}

std::array<std::uint8_t, 3> ToneCurve::near_levels(std::span<const double> value) const {
  static const NearLog kLog;
  static const NearLevels kLevels;
  const std::array<double, 3> c = linear(value, kLog);
  return {kLevels(c[0]), kLevels(c[1]), kLevels(c[2])};
}

bool is_nearly_even(std::span<const double> values, std::size_t channels, double times) {
  constexpr std::size_t kAsked = 5000;
  std::vector<double> lit;
  const std::size_t places = values.size() / channels, step = std::max<std::size_t>(1, places / kAsked);
  for (std::size_t k = 0; k < places; k += step)
    if (const double y = luminance(rgb(values.subspan(k * channels, channels))); y > 0) lit.push_back(y);
  if (lit.empty()) return false;
  const auto middle = lit.begin() + static_cast<std::ptrdiff_t>(lit.size() / 2);
  std::nth_element(lit.begin(), middle, lit.end());
  return *std::max_element(middle, lit.end()) < times * *middle;
}

ToneChoice first_tone(std::span<const double> values, std::size_t channels, double times, Tone usual) {
  return is_nearly_even(values, channels, times) ? ToneChoice{Tone::kMax, 0.7} : ToneChoice{usual, 1};
}

}  // namespace hottel

// How light becomes colours on a screen.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "viewer/picture/canvas.h"
#include "viewer/picture/picture_options.h"

namespace hottel {

// A tone curve fitted to the light of a picture. Values are linear; the colours are sRGB (IEC 61966-2-1).
//
//   kLinear    exposure times the value: the only one that does not look at the rest of the picture
//   kMax       the largest value of all channels becomes 1, times the exposure
//   kReinhard  Reinhard, Stark, Shirley, Ferwerda 2002, global: the geometric mean of the lit places becomes 0.25 times
//              the exposure, then Y (1 + Y / Ymax²) / (1 + Y), so that the brightest place is just white
//   kLog       log(1 + s Y) / log(1 + s Ymax), s = 2 times the exposure over the geometric mean
//
//   (1) 0 is black; brighter light is not darker on the screen
//   (2) kReinhard and kLog compress the luminance Y (of the sRGB primaries) and keep the hue; colours too bright for a
//       channel are mixed with grey of their luminance until they fit
//   (3) with one channel, or two, all colours are grey
class ToneCurve {
 public:
  // values: of all places of the picture, `channels` (1; 2, of which the first is shown: the solar
  // band; or at least 3 of which r, g, b are the first) for each.
  // Places that are NaN in all channels are passed over. REQUIRES finite values >= 0 else, exposure > 0.
  ToneCurve(Tone tone, double exposure, std::span<const double> values, std::size_t channels);

  // What the screen shows at a place with these values.
  Colour operator()(std::span<const double> value) const;
  // The same in the 256 levels of a screen: r, g, b. COST: a logarithm and a few ns.
  std::array<std::uint8_t, 3> levels(std::span<const double> value) const;
  // The same, each level off by one at most: for pictures that are drawn many times a second. COST: some 10 ns.
  std::array<std::uint8_t, 3> near_levels(std::span<const double> value) const;

  // Values are multiplied by this before the curve is applied: the scale to print. For kLog: s.
  double scale() const { return scale_; }

 private:
  template <class Log>
  std::array<double, 3> linear(std::span<const double> value, const Log& log_of_1_and) const;  // each in [0, 1]
  template <class Log>
  double curve(double luminance, const Log& log_of_1_and) const;

  Tone tone_;
  double scale_ = 1;
  double white_ = 1;  // the largest luminance, after scaling
  double log_white_ = 1;
};

// A curve and an exposure.
struct ToneChoice {
  Tone tone = kUsualTone2;
  double exposure = 1;
  friend bool operator==(const ToneChoice&, const ToneChoice&) = default;
};

// Whether light is nearly even: the brightest of the lit places is less than so many times as bright as half of them or
// more. Asked of some thousand of the places. False where nothing is lit.
bool is_nearly_even(std::span<const double> values, std::size_t channels, double times);

// The curve that light is looked at through at first: the usual one; where light is nearly even, which that makes
// white, kMax at less exposure.
ToneChoice first_tone(std::span<const double> values, std::size_t channels, double times, Tone usual);

}  // namespace hottel

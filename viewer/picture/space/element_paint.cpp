#include "viewer/picture/space/element_paint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "viewer/picture/colour_map.h"
#include "viewer/picture/palette.h"

namespace hottel {
namespace {

std::array<double, 3> linear(const Colour& colour) {
  return {linear_from_srgb(colour.r), linear_from_srgb(colour.g), linear_from_srgb(colour.b)};
}

std::vector<double> shown_of(const Colour& colour) {
  const std::array<double, 3> light = linear(colour);
  return {light.begin(), light.end()};
}

// A map of colours in linear light, from a table; between its stations off by less than a millionth.
class LinearMap {
 public:
  // map: of positions from lower to 1.
  LinearMap(Colour (*map)(double), double lower) : lower_(lower) {
    for (std::size_t k = 0; k <= kStations; ++k)
      stations_.push_back(linear(map(std::lerp(lower, 1.0, static_cast<double>(k) / static_cast<double>(kStations)))));
  }

  std::array<double, 3> operator()(double position) const {
    const double place = (position - lower_) / (1 - lower_) * static_cast<double>(kStations);
    const std::size_t k = std::min(static_cast<std::size_t>(place), kStations - 1);
    std::array<double, 3> result{};
    for (std::size_t c = 0; c < 3; ++c)
      result[c] = std::lerp(stations_[k][c], stations_[k + 1][c], place - static_cast<double>(k));
    return result;
  }

 private:
  static constexpr std::size_t kStations = 5 * 2000;  // the stations of the map are among them
  double lower_;
  std::vector<std::array<double, 3>> stations_;
};

std::array<double, 3> linear_scale_colour(const ColourScale& scale, double value) {
  static const LinearMap map(map_colour, 0), signed_map(signed_map_colour, -1);
  if (scale.has_zero && !(value > 0)) return linear(palette::kZero);
  return scale.about_zero ? signed_map(scale.signed_position(value)) : map(scale.position(value));
}

}  // namespace

bool ElementPaint3::has_value(std::uint32_t element) const { return !std::isnan(values[element * channels]); }

void ElementPaint3::show(std::span<const double> value, std::span<double> shown) const {
  if (!scale) {
    std::copy(value.begin(), value.end(), shown.begin());
    return;
  }
  const std::array<double, 3> colour = linear_scale_colour(*scale, value[0]);
  std::copy(colour.begin(), colour.end(), shown.begin());
}

ElementPaint3 light_paint_3(const SceneTable& scene, const RadiositySolution& solution) {
  ElementPaint3 paint;
  paint.channels = solution.channels.size() == 2 ? 1 : solution.channels.size();  // of two bands the solar one
  for (std::size_t i = 0; i < solution.channels[0].elements.size(); ++i)
    for (std::size_t c = 0; c < paint.channels; ++c) paint.values.push_back(solution.channels[c].elements[i].radiosity);
  paint.unknown.assign(paint.channels, 0);
  paint.black.assign(paint.channels, 0);
  for (std::size_t c = 0; c < paint.channels; ++c) paint.sky.push_back(to_double(scene.sky_emission.value[c]));
  return paint;
}

ElementPaint3 scale_paint_3(const ShownValues& values) {
  ElementPaint3 paint;
  for (const std::optional<double>& value : values.elements)
    paint.values.push_back(value.value_or(std::numeric_limits<double>::quiet_NaN()));
  paint.scale = values.scale;
  paint.unknown = shown_of(palette::kSolid);
  paint.black = shown_of(palette::kUnlitSolid);
  paint.sky = shown_of(palette::kSky);
  return paint;
}

}  // namespace hottel

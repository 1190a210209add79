#include "viewer/picture/light_contours.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "kernel/plain_functions.h"
#include "viewer/picture/contour_set.h"
#include "viewer/picture/smoothed_field.h"

namespace hottel {
namespace {

constexpr double kBeyondLevels = 16;  // how far values may lie beyond levels
constexpr double kCellsBlended = 1;   // the deviation by which light is blended
constexpr double kLeastContour = 14;  // units across

}  // namespace

double shown_mean(std::span<const double> value) {
  if (value.size() == 2) return value[0];
  double sum = 0;
  for (const double channel : value) sum += channel;
  return sum / static_cast<double>(value.size());
}

std::vector<double> light_contours(std::span<const double> values, std::size_t channels, int contours) {
  if (contours <= 0) return {};
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (std::size_t k = 0; k < values.size(); k += channels) {
    const double value = shown_mean(values.subspan(k, channels));
    if (!(value > 0) || std::isinf(value)) continue;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  return most > 0 ? contour_levels(least, most, contours) : std::vector<double>();
}

void draw_light_contours(PictureCanvas& canvas, PixelField light, std::span<const double> levels, double cell,
                         Pixel origin, double size) {
  if (levels.empty()) return;
  const double low = levels.front() / kBeyondLevels, high = levels.back() * kBeyondLevels;
  for (float& value : light.values) value = static_cast<float>(same_bits::log(std::clamp<double>(value, low, high)));
  const PixelField logs = smoothed_field(std::move(light), kCellsBlended * cell);
  std::vector<double> log_levels;
  for (const double level : levels) log_levels.push_back(same_bits::log(level));
  const std::vector<Contour> contours = contour_set(logs, log_levels, kLeastContour * size);
  std::vector<std::string> names;
  for (const Contour& contour : contours) names.push_back(fmt::format("{:.6g}", same_bits::exp(contour.level)));
  draw_contours(canvas, contours, names, logs, origin, size);
}

}  // namespace hottel

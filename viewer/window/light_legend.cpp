#include "viewer/window/light_legend.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "kernel/plain_functions.h"

namespace hottel {
namespace {

constexpr double kDecades = 1e-3;                                     // of the brightest
constexpr double kGap = 12, kBar = 420, kHigh = 76, kAboveLine = 54;  // units
constexpr double kLeastWindow = 3;                                    // heights of a legend
constexpr Colour kPaper{0.992, 0.988, 0.980, 0.9};

ColourScale scale_of(std::span<const double> values, std::size_t channels) {
  double low = 0, high = 0;
  for (std::size_t k = 0; k + channels <= values.size(); k += channels) {
    const double light = brightness_of(values.subspan(k, channels));
    if (!(light > 0)) continue;
    low = low > 0 ? std::min(low, light) : light;
    high = std::max(high, light);
  }
  low = std::max(low, kDecades * high);
  if (!(low < 0.999 * high)) return {0, high, false};
  const bool has_decades = std::floor(same_bits::log10(high)) > std::ceil(same_bits::log10(low));  // two to be labelled
  return {low, high, has_decades};
}

}  // namespace

double brightness_of(std::span<const double> light) {
  return light.size() < 3 ? light[0] : 0.2126 * light[0] + 0.7152 * light[1] + 0.0722 * light[2];
}

LightLegend::LightLegend(const ToneCurve& tone, std::span<const double> values, std::size_t channels, std::string title)
    : tone_(tone), channels_(channels), scale_(scale_of(values, channels)), title_(std::move(title)) {}

void LightLegend::draw(PictureCanvas& canvas, std::optional<double> marked, double bottom, double unit) const {
  if (is_dark()) return;
  const auto colour = [this](double value) { return tone_(std::vector<double>(channels_, value)); };
  draw_legend_on_paper(canvas, scale_, title_, {.colour = colour, .marked = marked}, bottom, unit);
}

void draw_legend_on_paper(PictureCanvas& canvas, const ColourScale& scale, const std::string& title,
                          const LegendMarks& marks, double bottom, double unit) {
  if (kLeastWindow * kHigh * unit > canvas.height()) return;
  const double gap = kGap * unit, low = std::min(bottom, canvas.height() - kAboveLine * unit) - kHigh * unit;
  const double bar = std::min(kBar * unit, (canvas.width() - 4 * gap) / 1.6);
  if (bar <= 0) return;
  const Pixel corner{2 * gap, low + 6 * unit};
  const double wide = draw_legend(canvas, scale, title, corner, bar, unit);  // drawn over by its paper
  canvas.fill_rectangle(Mark::kPaper, {gap, low}, {3 * gap + wide, low + kHigh * unit}, kPaper.with_alpha(1));
  draw_legend(canvas, scale, title, corner, bar, unit, marks);
}

}  // namespace hottel

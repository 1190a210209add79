#include "viewer/picture/scale_bar.h"

#include <fmt/format.h>

#include <cmath>

#include "kernel/plain_functions.h"
#include "viewer/picture/palette.h"

namespace hottel {
namespace {

// The largest of 1, 2, 5 times a power of ten that is not above the limit.
double round_length(double limit) {
  const double power = same_bits::pow(10, std::floor(same_bits::log10(limit)));
  for (const double factor : {5.0, 2.0})
    if (factor * power <= limit) return factor * power;
  return power;
}

}  // namespace

void draw_scale_bar(PictureCanvas& canvas, double pixels_per_length, const std::string& length_unit,
                    const ScaleBarPlace& place) {
  const double limit = place.room / pixels_per_length, unit = place.unit;
  if (!std::isfinite(limit) || !(limit > 1e-300)) return;
  const double length = round_length(limit), pixels = length * pixels_per_length;
  const double y = place.right.y, tick = 5 * unit, right = place.right.x, left = right - pixels;
  const double pen = 1.6 * unit;
  canvas.stroke(Mark::kScaleBar, {left, y}, {right, y}, palette::kInk, pen);
  for (const double x : {left, (left + right) / 2, right})
    canvas.stroke(Mark::kScaleBar, {x, y - (x == left || x == right ? tick : tick / 2)}, {x, y}, palette::kInk, pen);
  const TextStyle style{.size = 14 * unit, .colour = palette::kSoftInk, .anchor = TextAnchor::kCentre};
  canvas.text(Mark::kScaleBar, {(left + right) / 2, y + 21 * unit}, fmt::format("{:.6g} {}", length, length_unit),
              style);
}

}  // namespace hottel

// What the brightness of light in a window means: a bar through its tone curve, with values in their unit.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "viewer/picture/canvas.h"
#include "viewer/picture/colour_map.h"
#include "viewer/picture/tone_curve.h"

namespace hottel {

// The brightness of light of so many channels as one number: of r, g, b the luminance, of two bands the first.
double brightness_of(std::span<const double> light);

// The scale of light: from what is a thousandth of the brightest, or the darkest place that is lit, to the brightest;
// from 0 where all is as bright. What is nothing and what is not a number is passed over.
class LightLegend {
 public:
  LightLegend(const ToneCurve& tone, std::span<const double> values, std::size_t channels, std::string title);

  bool is_dark() const { return !(scale_.upper > 0); }  // nothing is lit
  const ColourScale& scale() const { return scale_; }
  // marked: the light to be marked on the bar. bottom: where the room for it ends.
  void draw(PictureCanvas& canvas, std::optional<double> marked, double bottom, double unit) const;

 private:
  ToneCurve tone_;
  std::size_t channels_;
  ColourScale scale_;
  std::string title_;
};

// Draws the legend of a scale on paper, at the left of a window, where its last line would be or higher: above
// `bottom`. A window that is less than three times as high as the legend has none.
void draw_legend_on_paper(PictureCanvas& canvas, const ColourScale& scale, const std::string& title,
                          const LegendMarks& marks, double bottom, double unit);

}  // namespace hottel

#include "viewer/picture/hatch.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace hottel {

void draw_hatch(PictureCanvas& canvas, std::span<const Pixel> outline, double spacing, double line_width,
                Colour colour) {
  if (outline.empty()) return;
  double lowest = outline.front().x + outline.front().y, highest = lowest;
  for (const Pixel& p : outline) {
    lowest = std::min(lowest, p.x + p.y);
    highest = std::max(highest, p.x + p.y);
  }
  std::vector<double> crossings;
  for (double level = (std::floor(lowest / spacing) + 0.5) * spacing; level < highest; level += spacing) {
    crossings.clear();
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const Pixel &a = outline[k], &b = outline[(k + 1) % outline.size()];
      const double above_a = a.x + a.y - level, above_b = b.x + b.y - level;
      if ((above_a < 0) != (above_b < 0)) crossings.push_back(std::lerp(a.x, b.x, above_a / (above_a - above_b)));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
      canvas.stroke(Mark::kHatch, {crossings[k], level - crossings[k]}, {crossings[k + 1], level - crossings[k + 1]},
                    colour, line_width);
  }
}

}  // namespace hottel

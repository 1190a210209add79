#include "viewer/picture/plane/solid_polygons.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/plane/arrangement/solid_regions.h"

namespace hottel {

std::vector<std::vector<Pixel>> solid_polygons(const Arrangement2& arrangement, const Frame2& frame) {
  const SolidRegions2 regions(arrangement);
  std::vector<std::vector<Pixel>> polygons(regions.count());
  for (std::uint32_t region = 0; region < regions.count(); ++region)
    for (const SolidRegions2::Border& border : regions.borders(region)) {
      std::vector<Pixel>& polygon = polygons[region];
      const bool is_first = polygon.empty();
      const std::size_t begin = polygon.size();
      for (const VertexId v : border) {
        polygon.push_back(frame.at(arrangement.vertices().to_scene(arrangement.vertices().exact(v))));
      }
      if (regions.borders(region).size() == 1) continue;
      polygon.push_back(polygon[begin]);
      if (!is_first) polygon.push_back(polygon.front());
    }
  return polygons;
}

void draw_hatch_2(PictureCanvas& canvas, std::span<const Pixel> outline, double spacing, double line_width,
                  Colour colour) {
  if (outline.empty()) return;
  double lowest = outline.front().x + outline.front().y, highest = lowest;
  for (const Pixel& p : outline) {
    lowest = std::min(lowest, p.x + p.y);
    highest = std::max(highest, p.x + p.y);
  }
  lowest = std::max(lowest, -spacing);
  highest = std::min(highest, canvas.width() + canvas.height() + spacing);
  std::vector<double> crossings;
  for (double level = (std::floor(lowest / spacing) + 0.5) * spacing; level < highest; level += spacing) {
    crossings.clear();
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const Pixel &a = outline[k], &b = outline[(k + 1) % outline.size()];
      const double above_a = a.x + a.y - level, above_b = b.x + b.y - level;
      if ((above_a < 0) != (above_b < 0)) crossings.push_back(std::lerp(a.x, b.x, above_a / (above_a - above_b)));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
      const double left = std::max({crossings[k], -spacing, level - canvas.height() - spacing});
      const double right = std::min({crossings[k + 1], canvas.width() + spacing, level + spacing});
      if (left >= right) continue;
      canvas.stroke(Mark::kHatch, {left, level - left}, {right, level - right}, colour, line_width);
    }
  }
}

}  // namespace hottel

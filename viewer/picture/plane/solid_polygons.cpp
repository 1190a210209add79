#include "viewer/picture/plane/solid_polygons.h"

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
        const ExactPoint2 p = arrangement.vertices().to_scene(arrangement.vertices().exact(v));
        polygon.push_back(frame.at(Point2{p.x, p.y}));
      }
      if (regions.borders(region).size() == 1) continue;
      polygon.push_back(polygon[begin]);
      if (!is_first) polygon.push_back(polygon.front());
    }
  return polygons;
}

}  // namespace hottel

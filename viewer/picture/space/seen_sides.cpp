#include "viewer/picture/space/seen_sides.h"

#include <utility>

#include "geometry/space/visibility/convex_cut.h"
#include "viewer/picture/space/eye_map.h"
#include "viewer/picture/space/projection.h"

namespace hottel {

std::vector<SeenSide3> seen_sides_3(const PreparedScene3& prepared, const Camera3& camera) {
  const VisibilityMap3 map = eye_map_3(prepared, camera);
  const Projection3 projection(camera);
  std::vector<SeenSide3> result;
  for (const VisibilityMap3::Fragment& fragment : map.fragments) {
    std::vector<Direction3> corners;
    for (std::uint32_t c = fragment.begin; c < fragment.end; ++c) corners.push_back(map.corners[c].direction);
    PixelPolygon outline = projection.picture(std::move(corners));
    if (outline.size() > 2) result.push_back({fragment.face, std::move(outline)});
  }
  return result;
}

std::vector<std::optional<std::uint32_t>> elements_of_sides_3(const PreparedScene3& prepared,
                                                              const ElementTable3& table) {
  std::vector<std::optional<std::uint32_t>> result(2 * prepared.occluders().size());
  for (const ElementTable3::Part& part : table.parts())
    if (!part.patch.is_sky() && table.has_row(part.label))
      if (auto& first = result[Face{part.patch.surface, part.is_back}.number()]; !first) first = part.label;
  return result;
}

PixelPolygon common_polygon_3(PixelPolygon polygon, const PixelPolygon& other) {
  const double sign = pixel_area_doubled_3(other) < 0 ? -1 : 1;
  return common_convex(
      std::move(polygon), other,
      [sign](const Pixel& a, const Pixel& b, const Pixel& p) {
        return sign * ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x));
      },
      place_between_3);
}

}  // namespace hottel

#include "geometry/space/scene/facet_scene.h"

#include <algorithm>
#include <utility>

namespace hottel {

std::optional<FacetScene3> facet_scene(const Scene3& scene) {
  const auto is_bent = [](const Polygon3& polygon) { return polygon.is_nearly_plane; };
  if (std::none_of(scene.polygons.begin(), scene.polygons.end(), is_bent)) return std::nullopt;
  FacetScene3 result{scene, {}};
  result.scene.surfaces.clear();
  result.scene.polygons.clear();
  std::vector<std::uint32_t> first;
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
    first.push_back(static_cast<std::uint32_t>(result.surface_of.size()));
    for (Polygon3& facet : facets_of(scene.polygons[s])) {
      result.scene.add(scene.surfaces[s], std::move(facet));
      result.surface_of.push_back(s);
    }
  }
  for (Mask3& mask : result.scene.masks) mask = {first[mask.surface], first[mask.base]};  // which are plane
  return result;
}

}  // namespace hottel

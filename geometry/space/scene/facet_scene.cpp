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
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s)
    for (Polygon3& facet : facets_of(scene.polygons[s])) {
      result.scene.add(scene.surfaces[s], std::move(facet));
      result.surface_of.push_back(s);
    }
  return result;
}

}  // namespace hottel

#include "solver/space/light/scene_light_shares.h"

#include "geometry/space/exchange/element_table.h"
#include "geometry/space/visibility/exact_map.h"
#include "kernel/support/naming_file.h"
#include "solver/space/light/light_shares.h"

namespace hottel {

Beam3 beam_of(const Light& light, const LightPlace3& place) {
  if (light.type == LightType::kPoint) return {};
  return {place.direction, light.focus, light.falloff};
}

std::vector<LightShares> light_shares(const PreparedScene3& prepared, Granularity granularity) {
  std::vector<LightShares> result;
  const Scene3& scene = prepared.scene;
  if (scene.lights.empty()) return result;
  const ElementTable3 table(scene, prepared.arrangement(), prepared.blockers(), granularity);
  for (std::size_t k = 0; k < scene.lights.size(); ++k) {
    const LightPlace3& place = scene.light_places[k];
    const LightShares3 shares = naming_file(
        scene.file, [&] { return light_shares(prepared, table, place.position, beam_of(scene.lights[k], place)); });
    LightShares& its = result.emplace_back();
    for (const LightShare3& share : shares.elements) its.of_element.push_back(share.bounds);
    its.sky = shares.sky.bounds;
    if (shares.is_in_solid) {
      const Solids3& solids = prepared.arrangement().solids();
      its.solid = scene.groups[solids.meshes()[*solids.around(place.position)].group].name;
    }
  }
  return result;
}

}  // namespace hottel

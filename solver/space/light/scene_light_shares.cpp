#include "solver/space/light/scene_light_shares.h"

#include <algorithm>

#include "geometry/space/visibility/exact_map.h"
#include "kernel/support/naming_file.h"
#include "solver/space/light/light_shares.h"

namespace hottel {

Beam3 beam_of(const Light& light, const LightPlace3& place) {
  if (light.type == LightType::kPoint) return {};
  return {place.direction, light.focus, light.falloff};
}

std::vector<LightShares> light_shares(const PreparedScene3& prepared, Granularity granularity) {
  if (prepared.scene.lights.empty()) return {};
  return LitElements3(std::make_shared<const PreparedScene3>(prepared), granularity).shares(prepared.scene);
}

LitElements3::LitElements3(std::shared_ptr<const PreparedScene3> prepared, Granularity granularity)
    : prepared_(std::move(prepared)),
      table_(prepared_->scene, prepared_->arrangement(), prepared_->blockers(), granularity),
      known_(std::make_unique<Maps>()) {}

std::vector<LightShares> LitElements3::shares(const Scene3& scene) const {
  std::vector<LightShares> result;
  for (std::size_t k = 0; k < scene.lights.size(); ++k) {
    const LightPlace3& place = scene.light_places[k];
    const LightShares3 shares = naming_file(scene.file, [&] {
      return light_shares(*prepared_, table_, *map_from(place.position), BeamPower3(beam_of(scene.lights[k], place)));
    });
    LightShares& its = result.emplace_back();
    for (const LightShare3& share : shares.elements) its.of_element.push_back(share.bounds);
    its.sky = shares.sky.bounds;
    if (shares.is_in_solid) {
      const Solids3& solids = prepared_->arrangement().solids();
      its.solid = scene.groups[solids.meshes()[*solids.around(place.position)].group].name;
    }
  }
  return result;
}

LitElements3::MapPtr LitElements3::map_from(const Point3& position) const {
  std::vector<MapPtr>& maps = known_->maps;
  const auto is_there = [&position](const MapPtr& map) { return map->eye() == position; };
  {
    const std::lock_guard lock(known_->mutex);
    if (const auto known = std::ranges::find_if(maps, is_there); known != maps.end()) {
      std::rotate(known, known + 1, maps.end());
      return maps.back();
    }
  }
  auto map = std::make_shared<const ExactMap3>(prepared_->blockers(), position);
  const std::lock_guard lock(known_->mutex);
  if (maps.size() == kMostMaps) maps.erase(maps.begin());
  maps.push_back(map);
  return map;
}

}  // namespace hottel

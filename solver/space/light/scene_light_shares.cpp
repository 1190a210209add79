#include "solver/space/light/scene_light_shares.h"

#include <algorithm>

#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/visibility/exact_visibility_map.h"
#include "kernel/support/with_file_context.h"
#include "solver/space/light/light_shares.h"

namespace hottel {
namespace {

// What a list has that passes a test, or null. It stands last then.
template <class Ptr, class Test>
Ptr take_known(std::mutex& mutex, std::vector<Ptr>& list, const Test& test) {
  const std::lock_guard lock(mutex);
  const auto known = std::ranges::find_if(list, test);
  if (known == list.end()) return nullptr;
  std::rotate(known, known + 1, list.end());
  return list.back();
}

template <class Ptr>
void keep(std::mutex& mutex, std::vector<Ptr>& list, const Ptr& made, std::size_t most) {
  const std::lock_guard lock(mutex);
  if (list.size() == most) list.erase(list.begin());
  list.push_back(made);
}

}  // namespace

Beam3 beam_of(const Light& light, const LightPlace3& place) {
  if (light.type != LightType::kSpot) return {};
  return {place.direction, light.focus, light.falloff};
}

ExactVisibilityMap3 exact_visibility_map_of(const PreparedScene3& prepared, const Light& light,
                                            const LightPlace3& place) {
  return light.is_sun() ? ExactVisibilityMap3::of_sun(prepared.occluders(), place.direction)
                        : ExactVisibilityMap3(prepared.occluders(), place.position);
}

bool is_lit_alike_3(const Light& a, const LightPlace3& at, const Light& b, const LightPlace3& there) {
  if (a.type != b.type) return false;
  if (a.is_sun()) return at.direction == there.direction;
  if (at.position != there.position) return false;
  return a.type == LightType::kPoint ||
         (a.focus == b.focus && a.falloff == b.falloff && at.direction == there.direction);
}

std::vector<LightShares> light_shares(const PreparedScene3& prepared, Granularity granularity) {
  if (prepared.scene.lights.empty()) return {};
  return LitElements3(std::make_shared<const PreparedScene3>(prepared), granularity).shares(prepared.scene);
}

LitElements3::LitElements3(std::shared_ptr<const PreparedScene3> prepared, Granularity granularity)
    : prepared_(std::move(prepared)), table_(*prepared_->elements(granularity)), known_(std::make_unique<Known>()) {}

std::vector<LightShares> LitElements3::shares(const Scene3& scene) const {
  std::vector<LightShares> result;
  for (std::size_t k = 0; k < scene.lights.size(); ++k) {
    const Light& light = scene.lights[k];
    const LightPlace3& place = scene.light_places[k];
    auto known = take_known(known_->mutex, known_->shares,
                            [&](const auto& one) { return is_lit_alike_3(one->light, one->place, light, place); });
    if (known == nullptr) {
      known = std::make_shared<const KnownShares>(KnownShares{light, place, compute(scene, k)});
      keep(known_->mutex, known_->shares, known, kMostShares);
    }
    result.push_back(known->shares);
  }
  return result;
}

LightShares LitElements3::compute(const Scene3& scene, std::size_t light) const {
  const LightPlace3& place = scene.light_places[light];
  if (scene.lights[light].is_sun()) return compute_sun(scene.lights[light], place);
  const LightShares3 shares = with_file_context(scene.file, [&] {
    return light_shares(*prepared_, table_, *map_from(place.position), BeamPower3(beam_of(scene.lights[light], place)));
  });
  LightShares result;
  for (const LightShare3& share : shares.elements) result.of_element.push_back(share.bounds);
  result.sky = shares.sky.bounds;
  if (shares.is_in_solid) {
    const Solids3& solids = prepared_->arrangement().solids();
    result.solid = solids.meshes()[*solids.around(place.position)].name;
  }
  return result;
}

LightShares LitElements3::compute_sun(const Light& light, const LightPlace3& place) const {
  LightShares result;
  result.of_element = sunlit_areas(*prepared_, table_, exact_visibility_map_of(*prepared_, light, place));
  result.whole = {0, 0};
  for (const Enclosure& area : result.of_element) result.whole = sum_of_nonnegative(result.whole, area);
  return result;
}

LitElements3::MapPtr LitElements3::map_from(const Point3& position) const {
  MapPtr map = take_known(known_->mutex, known_->maps, [&](const MapPtr& one) { return one->eye() == position; });
  if (map == nullptr) {
    map = std::make_shared<const ExactVisibilityMap3>(prepared_->occluders(), position);
    keep(known_->mutex, known_->maps, map, kMostMaps);
  }
  return map;
}

}  // namespace hottel

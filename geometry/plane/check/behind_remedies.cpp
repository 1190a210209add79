#include "geometry/plane/check/behind_remedies.h"

#include <algorithm>

namespace hottel {
namespace {

template <class Item>
void make_set(std::vector<Item>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

}  // namespace

BehindRemedies2::BehindRemedies2(const PreparedScene2& prepared, const FreeRegions2& free_regions)
    : prepared_(prepared),
      free_regions_(free_regions),
      regions_(prepared.arrangement.regions_behind(prepared.scene, free_regions)),
      cells_of_face_(2 * prepared.scene.surfaces.size()) {
  const Arrangement2& arrangement = prepared.arrangement;
  for (const PieceSideId side : arrangement.sides()) {
    if (arrangement.is_covered(side)) continue;
    std::vector<std::uint32_t>& list = cells_of_face_[arrangement.owner(side).number()];
    if (list.empty() || list.back() != free_regions.of(side)) list.push_back(free_regions.of(side));
  }
  for (std::vector<std::uint32_t>& list : cells_of_face_) make_set(list);
}

const BehindRemedy2* BehindRemedies2::of(std::uint32_t surface) {
  const std::vector<std::uint32_t>& region = regions_[prepared_.scene.surfaces[surface].group];
  if (region.empty() || !is_within({surface, true}, region)) return nullptr;
  const auto place = known_.find(region);
  return &(place != known_.end() ? place : known_.emplace(region, remedy(region)).first)->second;
}

bool BehindRemedies2::is_within(const Face& face, const std::vector<std::uint32_t>& free_regions) const {
  const std::vector<std::uint32_t>& list = cells_of_face_[face.number()];
  return !list.empty() && std::includes(free_regions.begin(), free_regions.end(), list.begin(), list.end());
}

BehindRemedy2 BehindRemedies2::remedy(const std::vector<std::uint32_t>& free_regions) const {
  const Scene2& scene = prepared_.scene;
  BehindRemedy2 result{free_regions, {}, false};
  for (const std::uint32_t free_region : free_regions)
    for (const PieceSideId side : free_regions_.sides(free_region)) {
      const Face face = prepared_.arrangement.owner(side);
      const std::optional<std::uint32_t> material = scene.surfaces[face.surface].material_of(face.is_back);
      if (!material) continue;
      result.emits |= !scene.materials[*material].emission.is_zero();
      if (is_within(face, free_regions)) result.swallows.push_back(face);
    }
  make_set(result.swallows);
  return result;
}

}  // namespace hottel

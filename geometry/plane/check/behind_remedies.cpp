#include "geometry/plane/check/behind_remedies.h"

#include <algorithm>

namespace hottel {
namespace {

std::uint32_t number(const FacePart& face) { return 2 * face.surface + (face.is_back ? 1 : 0); }

void make_set(std::vector<std::uint32_t>& list) {
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
    std::vector<std::uint32_t>& list = cells_of_face_[number(arrangement.owner(side))];
    if (list.empty() || list.back() != free_regions.of(side)) list.push_back(free_regions.of(side));
  }
  for (std::vector<std::uint32_t>& list : cells_of_face_) make_set(list);
}

const BehindRemedy2* BehindRemedies2::of(std::uint32_t surface) {
  const std::vector<std::uint32_t>& region = regions_[prepared_.scene.surfaces[surface].group];
  if (region.empty() || !is_within(2 * surface + 1, region)) return nullptr;
  const auto place = known_.find(region);
  return &(place != known_.end() ? place : known_.emplace(region, remedy(region)).first)->second;
}

bool BehindRemedies2::is_within(std::uint32_t face, const std::vector<std::uint32_t>& free_regions) const {
  const std::vector<std::uint32_t>& list = cells_of_face_[face];
  return !list.empty() && std::includes(free_regions.begin(), free_regions.end(), list.begin(), list.end());
}

BehindRemedy2 BehindRemedies2::remedy(const std::vector<std::uint32_t>& free_regions) const {
  const Scene2& scene = prepared_.scene;
  BehindRemedy2 result{free_regions, {}, false};
  for (const std::uint32_t free_region : free_regions)
    for (const PieceSideId side : free_regions_.sides(free_region)) {
      const std::uint32_t face = number(prepared_.arrangement.owner(side));
      const Surface2& surface = scene.surfaces[face / 2];
      if (face % 2 == 1 && !surface.back) continue;
      result.emits |= !scene.materials[face % 2 == 1 ? *surface.back : surface.material].emission.is_zero();
      if (is_within(face, free_regions)) result.swallows.push_back(face);
    }
  make_set(result.swallows);
  return result;
}

}  // namespace hottel

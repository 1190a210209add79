#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "geometry/name.h"
#include "geometry/plane/check/behind_remedies.h"
#include "geometry/plane/check/repair.h"

namespace hottel {
namespace {

using Regions = std::vector<std::uint32_t>;

Regions united(const Regions& a, const Regions& b) {
  Regions regions;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(regions));
  return regions;
}

// The faces with a material that look into some regions.
std::vector<Face> faces_around(const PreparedScene2& prepared, const FreeRegions2& regions, const Regions& some) {
  std::vector<Face> faces;
  for (const std::uint32_t region : some)
    for (const PieceSideId side : regions.sides(region)) {
      const Face face = prepared.arrangement.owner(side);
      if (!face.is_back || prepared.scene.surfaces[face.surface].back) faces.push_back(face);
    }
  return faces;
}

}  // namespace

void state_solids(Repair2& repair, const std::vector<std::uint32_t>& black_backs) {
  if (black_backs.empty()) return;
  Scene2& scene = repair.scene;
  const PreparedScene2 prepared = prepare(scene);
  const FreeRegions2 regions(prepared.arrangement.triangulation(), prepared.arrangement.side_count());
  BehindRemedies2 remedies(prepared, regions);
  Regions solid;
  std::set<const BehindRemedy2*> asked;  // regions that are left as they are
  for (const std::uint32_t s : black_backs) {
    const BehindRemedy2* remedy = remedies.of(s);
    if (remedy == nullptr) continue;
    if (remedy->emits || !remedy->swallows.empty()) {
      if (asked.insert(remedy).second)
        repair.steps.push_back({"not-repaired", scene.surfaces[s].name,
                                fmt::format("{} was not given \"behind\": \"solid\": {}",
                                            quoted_name(scene.groups[scene.surfaces[s].group].name),
                                            remedy->emits ? "something emits behind it, and that light would be lost"
                                                          : "faces behind it would be covered wholly")});
      continue;
    }
    if (std::includes(solid.begin(), solid.end(), remedy->free_regions.begin(), remedy->free_regions.end())) continue;
    Regions together = united(solid, remedy->free_regions);
    const std::vector<Face> faces = faces_around(prepared, regions, remedy->free_regions);
    if (std::any_of(faces.begin(), faces.end(), [&](const Face& face) { return remedies.is_within(face, together); }))
      continue;
    solid = std::move(together);
    const std::uint32_t group = scene.surfaces[s].group;
    scene.groups[group].behind = Behind::kSolid;
    repair.steps.push_back({"solid", scene.surfaces[s].name,
                            fmt::format("{} says \"behind\": \"solid\" now", quoted_name(scene.groups[group].name))});
  }
}

}  // namespace hottel

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "geometry/plane/check/region_findings.h"
#include "geometry/plane/check/repair.h"
#include "geometry/plane/check/wording.h"
#include "geometry/plane/scene/patches.h"

namespace hottel {

void reverse_inside_out(Repair2& repair) {
  RegionFindings2 told;
  try {
    const PreparedScene2 prepared = prepare(repair.scene);
    told = region_findings(prepared,
                           FreeRegions2(prepared.arrangement.triangulation(), prepared.arrangement.side_count()));
  } catch (const InputError&) {
    return;
  }
  const auto says_behind = [&](std::uint32_t s) {
    return repair.scene.groups[repair.scene.surfaces[s].group].behind != Behind::kByOutline;
  };
  for (std::vector<std::uint32_t> surfaces : told.certainly_reversed) {
    if (std::any_of(surfaces.begin(), surfaces.end(), says_behind)) continue;
    for (const std::uint32_t patch : patches_on(repair.scene, surfaces))
      if (std::ranges::count(surfaces, patch) == 0) surfaces.push_back(patch);
    for (const std::uint32_t s : surfaces) {
      auto& [from, to] = repair.scene.edges[s];
      std::swap(from, to);
      repair.steps.push_back(
          {"reversed", repair.scene.surfaces[s].name,
           fmt::format("{} goes from {} to {} now", names_text(repair.scene, {s}), place_text(from), place_text(to))});
    }
  }
}

}  // namespace hottel

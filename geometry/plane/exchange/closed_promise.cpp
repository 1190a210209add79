#include "geometry/plane/exchange/closed_promise.h"

#include <algorithm>
#include <vector>

#include "geometry/closed_promise.h"
#include "geometry/plane/arrangement/free_regions.h"
#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "kernel/support/with_file_context.h"

namespace hottel {
namespace {

// The surfaces of which a front with a material looks into the region that reaches infinity, ascending.
std::vector<std::uint32_t> fronts_outside(const PreparedScene2& prepared) {
  const Arrangement2& arrangement = prepared.arrangement;
  const FreeRegions2 regions(arrangement.triangulation(), arrangement.side_count());
  std::vector<std::uint32_t> surfaces;
  for (const PieceSideId side : regions.sides(0)) {
    if (arrangement.is_covered(side)) continue;
    const FacePart2& owner = arrangement.owner(side);
    if (!owner.is_back && prepared.scene.surfaces[owner.surface].material_of(false)) surfaces.push_back(owner.surface);
  }
  std::ranges::sort(surfaces);
  surfaces.erase(std::unique(surfaces.begin(), surfaces.end()), surfaces.end());
  return surfaces;
}

}  // namespace

void require_closed(const SceneTable& scene, const PreparedScene2& prepared, std::uint64_t memory,
                    const std::function<void(double)>& progress) {
  std::vector<std::uint32_t> outside = fronts_outside(prepared);
  if (outside.empty()) return;
  const Granularity granularity = is_cut(prepared.division) ? Granularity::kElement : Granularity::kFace;
  const ExchangeRequest asked{.granularity = granularity,
                              .wants_visibility = false,
                              .rows = RowChoice::fronts_of(std::move(outside)),
                              .memory = memory,
                              .progress = progress};
  require_closed(scene, with_file_context(scene.file, [&] { return exact_exchange(prepared, asked); }));
}

}  // namespace hottel

#include "io/results/space/light_region.h"

#include <array>

#include "kernel/written_double.h"

namespace hottel {

GridRegion3 region_of(const Grid3& grid) {
  const auto told = [](const auto& p) {
    return std::array{written_double(p.x), written_double(p.y), written_double(p.z)};
  };
  GridRegion3 region{told(grid.origin), told(grid.u), told(grid.v), grid.nu, grid.nv, grid.name};
  if (grid.w) region.w = told(*grid.w);
  region.nw = grid.nw;
  return region;
}

std::vector<std::size_t> array_shape(const Grid3& grid) {
  if (grid.is_volume()) return {grid.nw, grid.nv, grid.nu};
  return {grid.nv, grid.nu};
}

}  // namespace hottel

#include "io/results/space/light_region.h"

#include <algorithm>
#include <array>
#include <cmath>

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

bool are_sides_of(const std::array<std::array<double, 3>, 3>& told, const Grid3& grid) {
  const GridRegion3 own = region_of(grid);
  const auto& [origin, u, v] = told;
  double size = 0, off = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    size = std::max({size, std::abs(own.u[k]), std::abs(own.v[k])});
    off = std::max({off, std::abs(origin[k] - own.origin[k]), std::abs(u[k] - own.u[k]), std::abs(v[k] - own.v[k])});
  }
  return off <= 1e-9 * size;
}

std::vector<std::size_t> array_shape(const Grid3& grid) {
  if (grid.is_volume()) return {grid.nw, grid.nv, grid.nu};
  return {grid.nv, grid.nu};
}

}  // namespace hottel

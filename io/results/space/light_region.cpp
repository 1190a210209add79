#include "io/results/space/light_region.h"

#include "kernel/written_double.h"

namespace hottel {

PlanarRegion region_of(const Grid3& grid) {
  const auto told = [](const auto& p) {
    return std::array{written_double(p.x), written_double(p.y), written_double(p.z)};
  };
  return {told(grid.origin), told(grid.u), told(grid.v), grid.nu, grid.nv};
}

}  // namespace hottel

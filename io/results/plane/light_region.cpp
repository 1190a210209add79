#include "io/results/plane/light_region.h"

#include "kernel/written_double.h"

namespace hottel {

GridRegion region_of(const Grid2& grid) {
  const auto told = [](const Point2& p) { return std::array{written_double(p.x), written_double(p.y)}; };
  return {told(grid.min), told(grid.max), grid.nx, grid.ny, grid.name};
}

}  // namespace hottel

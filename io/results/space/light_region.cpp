#include "io/results/space/light_region.h"

#include <algorithm>
#include <array>

#include "kernel/written_double.h"

namespace hottel {

PlanarRegion region_of(const Grid3& grid) {
  const auto told = [](const auto& p) {
    return std::array{written_double(p.x), written_double(p.y), written_double(p.z)};
  };
  return {told(grid.origin), told(grid.u), told(grid.v), grid.nu, grid.nv, grid.name};
}

std::string grid_file(const std::string& file, const Grid3& grid) {
  if (grid.name.empty()) return file;
  const std::size_t ending = std::min(file.find('.'), file.size());
  return file.substr(0, ending) + "-" + grid.name + file.substr(ending);
}

}  // namespace hottel

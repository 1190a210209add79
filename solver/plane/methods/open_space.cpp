#include "solver/plane/methods/open_space.h"

#include "geometry/plane/arrangement/free_regions.h"

namespace hottel {

std::vector<char> borders_open_space(const Arrangement2& arrangement, const ElementTable2& table) {
  const FreeRegions2 regions(arrangement.triangulation(), arrangement.side_count());
  std::vector<char> result(table.count(), 0);
  for (const PieceSideId side : regions.sides(0)) result[table.of(side)] = 1;
  return result;
}

}  // namespace hottel

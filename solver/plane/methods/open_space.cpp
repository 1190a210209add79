#include "solver/plane/methods/open_space.h"

#include "geometry/plane/arrangement/cells.h"

namespace hottel {

std::vector<char> borders_open_space(const Arrangement2& arrangement, const Labels2& labels) {
  const Cells2 cells(arrangement.triangulation(), arrangement.side_count());
  std::vector<char> result(labels.count(), 0);
  for (const PieceSideId side : cells.sides(0)) result[labels.of(side)] = 1;
  return result;
}

}  // namespace hottel

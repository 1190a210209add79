#include "geometry/space/exchange/written_corners.h"

#include "geometry/space/exchange/element_table.h"
#include "kernel/written_double.h"

namespace hottel {

std::vector<std::vector<std::array<double, 3>>> written_corners(const ElementTable3& table, const Vertices3& vertices) {
  std::vector<std::vector<std::array<double, 3>>> result(table.count());
  for (std::uint32_t label = 0; label < table.count(); ++label) {
    const auto parts = table.parts(label);
    if (parts.size() != 1) continue;
    for (const Point3& p : corners_of(vertices, parts.front().patch))
      result[label].push_back({written_double(p.x), written_double(p.y), written_double(p.z)});
  }
  return result;
}

}  // namespace hottel

#include "geometry/plane/prepared/element_pieces.h"

#include <algorithm>

#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "kernel/written_double.h"

namespace hottel {

std::vector<std::vector<WrittenPiece2>> element_pieces(const PreparedScene2& prepared, Granularity granularity) {
  const ElementTable2& table = *prepared.elements(granularity);
  const Vertices2& vertices = prepared.arrangement.vertices();
  std::vector<std::vector<WrittenPiece2>> result(table.count());
  if (granularity == Granularity::kGroup) return result;
  for (std::uint32_t label = 0; label < table.count(); ++label) {
    const bool is_back = table.elements()[label].is_back;
    for (const Segment2& run : table.runs(label)) {
      const Point2 from = vertices.to_scene(vertices.exact(is_back ? run.b : run.a)),
                   to = vertices.to_scene(vertices.exact(is_back ? run.a : run.b));
      result[label].push_back(
          {written_double(from.x), written_double(from.y), written_double(to.x), written_double(to.y)});
    }
    if (is_back) std::ranges::reverse(result[label]);
  }
  return result;
}

}  // namespace hottel

#include "io/results/plane/polygon_names.h"

#include <cmath>

#include "kernel/support/failure.h"
#include "kernel/written_double.h"

namespace hottel {

std::string no_polygon_name(const PreparedScene2& prepared, const RoundedPolygon2& polygon) {
  return polygon.solid == Solids2::kNone ? "sky" : "#in " + prepared.scene.groups[polygon.solid].name;
}

void require_finite(const RoundedPolygon2::Corner& corner, std::size_t point) {
  for (const double coordinate : {corner.x, corner.y})
    if (!std::isfinite(coordinate))
      require_double(coordinate, "a corner of what point " + std::to_string(point) + " sees",
                     "; --exact writes it to a csv");
}

}  // namespace hottel

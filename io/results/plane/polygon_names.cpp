#include "io/results/plane/polygon_names.h"

#include <cmath>

#include "kernel/support/failure.h"

namespace hottel {

std::string no_polygon_name(const PreparedScene2& prepared, const RoundedPolygon2& polygon) {
  return polygon.solid == Solids2::kNone ? "sky" : "#in " + prepared.scene.groups[polygon.solid].name;
}

void require_finite(const RoundedPolygon2::Corner& corner, std::size_t point) {
  if (!std::isfinite(corner.x) || !std::isfinite(corner.y))
    throw RequestError("a corner of what point " + std::to_string(point) +
                       " sees is beyond the range of doubles; --exact writes it to a csv");
}

}  // namespace hottel

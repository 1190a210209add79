#include "io/scene/plane/map_position.h"

#include "io/scene/json_fields.h"
#include "io/scene/plane/well_known_text.h"

namespace hottel {

Point2 read_position_2(const JsonValue& value, PassedOver& passed_over) {
  require_kind(value, JsonKind::kArray, {"a position"});
  if (value.size() < 2 || value.size() > kMostCoordinates)
    refuse(value, "a position in the plane has two coordinates, not " + std::to_string(value.size()));
  Point2 point;
  std::size_t k = 0;
  for (const JsonValue item : value.items()) {
    Rational coordinate = read_number(item, {"a coordinate"});
    if (k < 2) (k == 0 ? point.x : point.y) = std::move(coordinate);
    ++k;
  }
  if (value.size() > 2) passed_over.add(PassedKind::kThirdCoordinate, {value.file(), value.line()});
  return point;
}

}  // namespace hottel

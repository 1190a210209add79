// Positions of GeoJSON.
#pragma once

#include "geometry/plane/point.h"
#include "io/scene/exact_json.h"
#include "io/scene/passed_over.h"

namespace hottel {

// Returns the first two coordinates of a position, exactly as typed. A third one, and a measure after it, are passed
// over and counted. Throws InputError for anything but a list of two to four numbers.
Point2 read_position_2(const JsonValue& value, PassedOver& passed_over);

}  // namespace hottel

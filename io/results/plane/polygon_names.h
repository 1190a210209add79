// What is told of visibility polygons in files, beside the names of their sides (polygons_of_points.h).
#pragma once

#include <string>

#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/visibility/polygons_of_points.h"

namespace hottel {

// Returns what is told of a point without corners: "#in NAME" in a solid, else "sky".
std::string no_polygon_name(const PreparedScene2& prepared, const RoundedPolygon2& polygon);

// Throws RequestError unless both coordinates are finite doubles.
void require_finite(const RoundedPolygon2::Corner& corner, std::size_t point);

}  // namespace hottel

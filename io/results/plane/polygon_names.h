// What the sides of visibility polygons are called in files.
#pragma once

#include <string>

#include "geometry/plane/arrangement/prepared_scene.h"
#include "geometry/plane/visibility/rounded_polygon.h"

namespace hottel {

// Returns the name of what is seen after a corner: that of the face, "sky", "#range" along an arc, "" along a ray from
// the point or an edge at it. No face can be called like the last three: names have no '#'.
std::string polygon_side_name(const PreparedScene2& prepared, PieceSideId after);

// Returns what is told of a point without corners: "#in NAME" in a solid, else "sky".
std::string no_polygon_name(const PreparedScene2& prepared, const RoundedPolygon2& polygon);

// Throws RequestError unless both coordinates are finite doubles.
void require_finite(const RoundedPolygon2::Corner& corner, std::size_t point);

}  // namespace hottel

// Which sides of pieces a camera sees where.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/face.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/scene/scene.h"
#include "viewer/picture/space/pixel_values.h"

namespace hottel {

// A polygon of the picture in which one side of a piece is seen.
struct SeenSide3 {
  Face side;             // its surface is the number of a piece
  PixelPolygon outline;  // convex
};

// Returns what a camera sees but the sky: no two share an area, those of one side follow each other. Throws
// RequestError where the eye is in a solid. REQUIRES a camera without a problem. COST: that of a map.
std::vector<SeenSide3> seen_sides_3(const PreparedScene3& prepared, const Camera3& camera);

// Returns an element of each side of a piece, by its number: the first of those that have a row; nothing where there is
// none, and the side is black.
std::vector<std::optional<std::uint32_t>> elements_of_sides_3(const PreparedScene3& prepared,
                                                              const ElementTable3& table);

// The part of a convex polygon of a picture inside another one, whichever way that goes around.
PixelPolygon common_polygon_3(PixelPolygon polygon, const PixelPolygon& other);

}  // namespace hottel

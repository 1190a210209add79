// Lines that tell surfaces apart in what a camera sees.
#pragma once

#include <vector>

#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/scene/scene.h"
#include "viewer/picture/canvas.h"

namespace hottel {

// A straight line in a picture, in pixels.
struct OutlineStroke3 {
  Pixel from, to;
};

// Two neighbours that are bent by at most so much are one surface that is round. [degrees]
inline constexpr double kRoundBend3 = 30;

// Returns the outlines of what a camera sees: the borders of sides of pieces, where nothing goes on beyond.
//
//   (1) what hides what is decided exactly (VisibilityMap3): hidden lines are not there, and parts of lines end where
//       they are hidden
//   (2) at a border a surface goes on where a side of the same group and the same material begins that is seen too, in
//       one plane with it or bent by at most kRoundBend3. So elements, triangles of a mesh and pieces that a polygon
//       was cut into have no lines between them; creases, silhouettes, borders of materials and open borders do
//   (3) where two pieces pierce each other is a line
//   (4) what is on one line of space, without a gap, is one stroke; strokes do not leave the picture
//
// Throws RequestError where the eye is in a solid. REQUIRES a camera without a problem. COST: that of a map, and some
// 20 microseconds for each side of a piece that is seen.
std::vector<OutlineStroke3> seen_outlines_3(const PreparedScene3& prepared, const Camera3& camera);

}  // namespace hottel

// What a camera sees of the light of a scene, as pixels before tone mapping.
#pragma once

#include <cstddef>
#include <cstdint>

#include "geometry/element.h"
#include "geometry/space/scene/scene.h"
#include "solver/radiosity/radiosity_solution.h"
#include "viewer/picture/space/pixel_values.h"
#include "viewer/picture/space/seen_parts.h"

namespace hottel {

struct PreparedScene3;

// Returns what is shown in the picture of a camera: of each element its value, or of places of it where they are
// blended; of what has none, of black sides and of the sky what the paint says.
//
//   (1) a pixel is the mean over its area of what is shown there, each point by itself: what hides what is decided
//       exactly (VisibilityMap3), areas are in doubles. So the picture is without steps
//   (2) a picture of twice the pixels, averaged by fours, is the same but for rounding, where values are not blended
//   (3) without blending, pixels integrate what the elements show; with it, a pixel takes the value in the middle of
//       what it has of each triangle
//
// Throws RequestError where the eye is in a solid. REQUIRES a camera without a problem (camera_problem). COST: that of
// a map, and of its pixels.
PixelValues3 camera_view_3(const SeenScene3& scene, const Camera3& camera);

// The light of a solution, each element in its radiosity as radiosity.csv says it. REQUIRES the solution of the scene's
// matrix by that granularity.
PixelValues3 camera_view_3(const PreparedScene3& prepared, Granularity granularity, const RadiositySolution& solution,
                           const Camera3& camera);

// Returns a camera for a scene that has none. Where its middle sees more of the sky than of the scene, from outside,
// above. Else from within, near the middle of a side or a corner, wherever an eye sees faces with a material in at
// least half of all directions; from outside where none of these does. 800 x 600 pixels. COST: two maps as a rule, nine
// at the most.
Camera3 default_camera_3(const PreparedScene3& prepared);

}  // namespace hottel

// Light of lamps and suns where it arrives first, as a camera sees it.
#pragma once

#include <span>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/scene/scene.h"
#include "solver/radiosity/direct_light.h"
#include "solver/radiosity/radiosity_solution.h"
#include "viewer/picture/space/element_paint.h"
#include "viewer/picture/space/pixel_values.h"
#include "viewer/picture/space/seen_sides.h"

namespace hottel {

// Returns the irradiance of elements by lamps and suns directly, by element and channel of the light. shares: of the
// lights of the scene, on the elements of the table.                                                        [W/m²]
std::vector<double> direct_irradiances_3(const SceneTable& scene, const ElementTable3& table, std::size_t channels,
                                         std::span<const LightShares> shares);

// The light of a solution as light_paint_3 has it, without what elements reflect of light that comes to them from lamps
// and suns directly. shares: of the lights of the scene, on the elements of the solution.
ElementPaint3 reflected_paint_3(const PreparedScene3& prepared, const ElementTable3& table,
                                const RadiositySolution& solution, std::span<const LightShares> shares);

// Adds to the pixels of a camera what faces reflect of that light, each point by itself.
//
//   (1) shadows end where they do: parts of faces that are lit are cut exactly (DirectLight3::lit_parts), and pixels
//       have them by area. The border of a beam is taken as straight in parts of pixels in which it all but is
//   (2) over what is seen of an element it integrates what its share of the light says
//
// seen: all that the camera sees, as it is told by seen_sides_3. REQUIRES pixels of as many channels as the light has;
// of two bands of one. COST: an exact map a light, and some 100 ns for each pixel that is lit.
void add_direct_light_3(const PreparedScene3& prepared, const ElementTable3& table, const RadiositySolution& solution,
                        const Camera3& camera, std::span<const SeenSide3> seen, PixelValues3& pixels);

}  // namespace hottel

// What a camera sees of the light of a scene, as pixels before tone mapping.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/element.h"
#include "geometry/space/scene/scene.h"
#include "solver/radiosity/radiosity_solution.h"
#include "viewer/picture/canvas.h"

namespace hottel {

struct PreparedScene3;

// Rows of pixels from top to bottom; the channels of a pixel are beside each other. [unit: that of radiosity]
struct PixelValues3 {
  std::uint32_t width = 0, height = 0;
  std::size_t channels = 1;
  std::vector<double> values;

  std::span<const double> at(std::uint32_t x, std::uint32_t y) const {
    return std::span(values).subspan((std::size_t{y} * width + x) * channels, channels);
  }
};

// Adds `value` times the part of each pixel that a convex polygon covers. What lies outside of the picture counts
// nothing. Exact areas, in doubles. COST: some nanoseconds a pixel, and 100 for each that the border passes.
void add_polygon(std::span<const Pixel> polygon, std::span<const double> value, PixelValues3& pixels);

// Returns the light in the picture of a camera: of each element its radiosity, of black sides 0, of the sky what it
// emits.
//
//   (1) a pixel is the mean over its area of what is seen there, each point by itself: what hides what is decided
//       exactly (PointMap3), areas are in doubles. So the picture is without steps, and integrates what radiosity.csv
//       says
//   (2) a picture of twice the pixels, averaged by fours, is the same but for rounding
//
// Throws RequestError where the eye is in a solid. REQUIRES a camera without a problem (camera_problem), and the
// solution of the scene's matrix by that granularity. COST: that of a map, and of its pixels.
PixelValues3 camera_view_3(const PreparedScene3& prepared, Granularity granularity, const RadiositySolution& solution,
                           const Camera3& camera);

// Returns a camera for a scene that has none: within it where its middle sees more of the scene than of the sky, from
// near the middle of a side; else from outside, above. 800 x 600 pixels.
Camera3 default_camera_3(const PreparedScene3& prepared);

}  // namespace hottel

// Pixels drawn over pixels.
#pragma once

#include "viewer/picture/canvas.h"
#include "viewer/picture/raster.h"

namespace hottel {

// Draws the source, stretched over a rectangle of the target.
//
//   (1) the pixels whose centres lie in the rectangle are drawn, its left and upper sides included; no others
//   (2) not smooth: each becomes the pixel of the source that its centre lies in
//   (3) smooth: blended linearly between the centres of the source's pixels, and as the nearest of them beyond; each
//       level is within 2 of the exact one, and an even colour stays what it is
//   (4) a source without pixels, and a rectangle without area or turned inside out, draw nothing
//
// Throws ContractViolation unless both rasters have width * height pixels.
// REQUIRES: an opaque source, not the target itself; finite corners.
// COST: on one core about 0.3 ns a pixel drawn, smooth 3 ns.
void draw_pixels(Raster& target, Pixel top_left, Pixel bottom_right, const Raster& source, bool smooth);

// Takes this fraction of every colour away, so that 1 leaves black; opacities stay. Levels are rounded down.
// Throws ContractViolation unless fraction is in [0, 1].
void dim(Raster& raster, double fraction);

}  // namespace hottel

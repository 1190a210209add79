// Pixels as a screen takes them.
#pragma once

#include <cstdint>

#include "viewer/picture/raster.h"
#include "viewer/picture/space/pixel_values.h"
#include "viewer/picture/tone_curve.h"

namespace hottel {

// Returns values through a tone curve; null: values are r, g and b in linear light. Below them are so many black rows.
Raster pixel_raster_3(const PixelValues3& pixels, const ToneCurve* tone, std::uint32_t rows_below = 0);

}  // namespace hottel

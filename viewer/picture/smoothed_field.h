// A field of pixels without what is finer than its cells.
#pragma once

#include "viewer/picture/contours.h"

namespace hottel {

// Returns the field in which each value is a mean of those around it, about as a bell curve of that standard deviation
// weighs them. [pixels]
//
//   (1) no value is blended through a wall: a mean is along rows, then along columns, as far as no two neighbours have
//       only squares between them that are cut, and no pixel is without a value
//   (2) no value leaves the range of those that it is a mean of; NaN stays NaN
//   (3) equal values stay, but for roundings; a field that rises evenly stays, farther than 3 deviations from its ends
// COST: some 50 ns a pixel, on all threads, whatever the deviation.
PixelField smoothed_field(PixelField field, double deviation);

}  // namespace hottel

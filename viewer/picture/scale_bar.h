// A bar that tells how long a length is in a picture.
#pragma once

#include <string>

#include "viewer/picture/canvas.h"

namespace hottel {

// Where a bar ends, how wide it may be in pixels, and the size of everything: a text is some 14 units high.
struct ScaleBarPlace {
  Pixel right;
  double room = 0, unit = 1;
};

// Draws a bar of a round length (1, 2 or 5 times a power of ten, in the unit of the scene), its length with the unit
// beneath it; nothing where no length in doubles is so long.
void draw_scale_bar(PictureCanvas& canvas, double pixels_per_length, const std::string& length_unit,
                    const ScaleBarPlace& place);

}  // namespace hottel

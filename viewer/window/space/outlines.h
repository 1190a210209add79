// Outlines of what is seen of a scene, where light alone does not tell its faces apart.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/space/prepared/element_table.h"
#include "viewer/picture/raster.h"
#include "viewer/picture/space/seen_picture.h"

namespace hottel {

// Darkens the pixels of a picture at which one face ends and another begins, so many pixels wide. REQUIRES that parts
// are those of the raster's picture, with elements of the table. COST: some ms a megapixel.
void draw_outlines_3(Raster& raster, const std::vector<SeenPicture3::Part>& parts, const ElementTable3& table,
                     std::uint32_t width);

}  // namespace hottel

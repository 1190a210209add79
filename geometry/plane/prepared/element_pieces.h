// Where elements of the plane lie, as files hold it.
#pragma once

#include <array>
#include <vector>

#include "geometry/element.h"

namespace hottel {

struct PreparedScene2;

// A part of an element in scene coordinates: x0, y0, x1, y1.
using WrittenPiece2 = std::array<double, 4>;

// Returns what is left of each element, in the order of the elements: straight pieces that share no more than an end,
// one where nothing of it is covered or owned by others; none where nothing is left, and none of groups.
//
//   (1) pieces, and their ends, are in the order of the surface from its first point to its second, those of backs too
//   (2) each coordinate is as written_double has it: NaN where its nearest double is 0 and it is not
// COST: that of the table of elements.
std::vector<std::vector<WrittenPiece2>> element_pieces(const PreparedScene2& prepared, Granularity granularity);

}  // namespace hottel

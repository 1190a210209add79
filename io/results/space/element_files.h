// Which element of a scene in space is which, as a file beside a matrix.
#pragma once

#include <span>

#include "geometry/space/exchange/written_outlines.h"
#include "io/results/factor_files.h"

namespace hottel {

// `index,face,element,area,material,points`: a line an element, 1-based, the sky last. points: the corners of what is
// left of it, "x y z;x y z;...", shortest decimals; of several loops, an outline and its holes, with "|" between them,
// and "||" between parts; empty of groups, of the sky and where nothing is left.
// Throws RequestError for an area or a coordinate beyond the range of doubles.
// REQUIRES the outline of each element (written_outlines).
void write_faces_csv_3(const FactorTable& table, std::span<const WrittenOutline3> outlines, const Sink& sink);

}  // namespace hottel

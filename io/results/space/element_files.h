// Which element of a scene in space is which, as a file beside a matrix.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "io/results/factor_files.h"

namespace hottel {

// `index,face,element,area,material,points`: a line an element, 1-based, the sky last. points: its corners in order,
// "x y z;x y z;...", shortest decimals; empty of groups and of the sky.
// Throws RequestError for an area or a coordinate beyond the range of doubles.
// REQUIRES the corners of each element (written_corners).
void write_faces_csv_3(const FactorTable& table, std::span<const std::vector<std::array<double, 3>>> corners,
                       const Sink& sink);

}  // namespace hottel

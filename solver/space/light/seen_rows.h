// What the cells of a grid in space see, as rows of a matrix.
#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/scene/scene.h"

namespace hottel {

// By cell, in the order of IlluminationGrid3, what its centre sees: elements of the table, then the sky as column
// table.count(), in the order in which they are found, each with the fraction of all directions that it has.
//
//   (1) the mean irradiance of illuminate_points() is that matrix times the radiosities, the sky's emission last, but
//       for rounding, and but for what lights add
//   (2) a row sums to 1 but for rounding; it is empty where the centre is in a solid
//   (3) the same bits for any number of threads
//
// progress: fraction done; may throw to stop. Throws RequestError where the rows take more than so many bytes. COST:
// that of illuminate_points().
using SeenRow3 = std::vector<std::pair<std::uint32_t, double>>;
std::vector<SeenRow3> seen_rows(const PreparedScene3& prepared, const ElementTable3& table, const Grid3& grid,
                                std::uint64_t memory, const std::function<void(double)>& progress = {});

}  // namespace hottel

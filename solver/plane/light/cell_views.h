// Looking around from the centre of every cell of a grid.
#pragma once

#include <functional>

#include "geometry/plane/arrangement/prepared_scene.h"
#include "geometry/plane/visibility/point_location.h"
#include "geometry/plane/visibility/view.h"

namespace hottel {

// Where the centres of the cells lie.
Point2 cell_centre(const Grid2& grid, std::uint32_t ix, std::uint32_t iy);

// Calls visit(cell, eye, location, view) once for each cell, number iy * nx + ix, with what its exact centre sees; from
// many threads at once, in any order.
//
//   (1) what visit is given depends on the cell's centre alone, not on the grid around it or on the threads
// progress: fraction done, called by the calling thread; may throw to stop. Throws Interrupted when asked to stop.
// REQUIRES at least one cell, min < max.
// COST: that of tile_views.h for each eight by eight cells; numbers of a row and of a column are prepared once.
using CellVisit2 = std::function<void(std::size_t, const Eye2&, const Location2&, const View2&)>;
void for_each_cell_view(const PreparedScene2& prepared, const Grid2& grid, const std::function<void(double)>& progress,
                        const CellVisit2& visit);

}  // namespace hottel

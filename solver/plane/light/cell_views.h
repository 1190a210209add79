// Looking around from the centre of every cell of a grid.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/visibility/point_location.h"
#include "geometry/plane/visibility/view.h"

namespace hottel {

// Where the centres of the cells lie.
Point2 cell_centre(const Grid2& grid, std::uint32_t ix, std::uint32_t iy);

// Cells that look around together, and what they see.
class TileViews2;
class EyeTile2;
class CellTile2 {
 public:
  std::size_t size() const { return columns_ * rows_; }
  // The number of the k-th of them, and what its centre sees. REQUIRES k < size().
  std::size_t cell(std::size_t k) const { return first_cell_ + k / columns_ * cells_in_a_row_ + k % columns_; }
  const Eye2& eye(std::size_t k) const;
  const Location2& location(std::size_t k) const;
  const View2& view(std::size_t k) const;

 private:
  friend class CellViews2;
  CellTile2(const EyeTile2& eyes, const TileViews2& views, std::size_t first_cell, std::size_t cells_in_a_row);
  std::size_t in_tile(std::size_t k) const;

  const EyeTile2& eyes_;
  const TileViews2& views_;
  std::size_t columns_, rows_, first_cell_, cells_in_a_row_;
};

// A grid over a scene, ready to be looked around from: cells in bands, which are some rows of cells each, from below.
//
//   (1) what is seen from a cell depends on its centre alone, not on the grid around it, on bands or on threads
// REQUIRES that the scene outlives it, and at least one cell, min < max (else ContractViolation).
// COST: of making it, linear in the scene, and an exact number for each row and each column.
class CellViews2 {
 public:
  CellViews2(const PreparedScene2& prepared, const Grid2& grid);
  CellViews2(const CellViews2&) = delete;
  CellViews2& operator=(const CellViews2&) = delete;

  const Vertices2& vertices() const { return vertices_; }
  std::size_t cells() const { return columns_.size() * rows_.size(); }
  std::size_t bands() const { return (rows_.size() + rows_in_a_band_ - 1) / rows_in_a_band_; }
  // The first cell of a band; of bands(), the number of cells. REQUIRES band <= bands().
  std::size_t first_cell(std::size_t band) const;

  // Calls visit with tiles that together have each cell of the band once, from many threads at once, in any order.
  // Throws Interrupted when asked to stop. COST: that of tile_views.h for each tile.
  void look_around(std::size_t band, const std::function<void(const CellTile2&)>& visit) const;

 private:
  const Vertices2& vertices_;
  PointLocation2 location_;
  std::vector<EyeCoordinate2> columns_, rows_;
  std::size_t tile_side_, rows_in_a_band_;
};

// Calls visit(cell, eye, location, view) once for each cell, number iy * nx + ix, with what its exact centre sees; from
// many threads at once, in any order.
//
// progress: fraction done, called by the calling thread; may throw to stop. Throws Interrupted when asked to stop.
using CellVisit2 = std::function<void(std::size_t, const Eye2&, const Location2&, const View2&)>;
void for_each_cell_view(const PreparedScene2& prepared, const Grid2& grid, const std::function<void(double)>& progress,
                        const CellVisit2& visit);

}  // namespace hottel

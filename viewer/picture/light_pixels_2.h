// A grid of light as the pixels of a picture, before tone mapping.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/scene/scene_2.h"
#include "solver/illumination/illumination_grid_2.h"

namespace hottel {

// Each cell becomes across x up pixels, blended between the centres of the cells (bilinear).
//
//   (1) the picture integrates to the grid: every cell's value counts in its pixels and those around as much as its own
//       area; with walls, for each cell that no wall comes near (a cell and a half)
//   (2) with walls light does not leak: a pixel takes the values of those of the four nearest centres to which no edge
//       of the scene bars the way; a centre on an edge, whose value mixes both sides, counts as barred
//   (3) every pixel lies between the least and the largest of the values around it; where they are NaN (in solids) it
//       takes the others, and is NaN only where there are none
// Where to draw is decided in doubles.
class LightPixels2 {
 public:
  // walls: the scene, or null: none. REQUIRES across, up > 0; the grid outlives this.
  LightPixels2(const IlluminationGrid& grid, std::uint32_t across, std::uint32_t up, const Scene2* walls);

  std::uint32_t width() const { return grid_.grid.nx * across_; }
  std::uint32_t height() const { return grid_.grid.ny * up_; }
  // Pixels of a row of cells, in C order (up, width, channels), the lowest row of pixels first. Callable from many
  // threads at once.
  std::vector<double> row_of_cells(std::uint32_t iy) const;

 private:
  struct Wall {
    double ax, ay, bx, by;  // in cells from the lower left corner of the grid
  };
  void blend(double x, double y, std::uint32_t ix, std::uint32_t iy, double* pixel) const;
  bool is_barred(double x, double y, double to_x, double to_y, std::size_t cell) const;

  const IlluminationGrid& grid_;
  std::uint32_t across_, up_;
  std::vector<Wall> walls_;
  std::vector<std::uint32_t> near_begin_, near_;  // by cell: walls that come near it
};

}  // namespace hottel

// A grid of light as the pixels of a picture, before tone mapping.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/scene/scene.h"
#include "solver/plane/light/illumination_grid.h"
#include "viewer/picture/plane/barred_pixels.h"

namespace hottel {

// The light of a grid in pixels. Each cell becomes across x up of them, blended between the centres
// of the cells (bilinear).
//
//   (1) the picture integrates to the grid: every cell's value counts in its pixels and those around as much as its own
//       area; with walls, for each cell that no wall comes near (a cell and a half)
//   (2) with walls light does not leak: a pixel takes the values of those of the four nearest centres to which no edge
//       of the scene bars the way; a centre on an edge, whose value mixes both sides, counts as barred
//   (3) every pixel lies between the least and the largest of the values around it; where they are NaN (in solids) it
//       takes the others, and is NaN only where there are none
//   (4) light that comes straight from a light of the scene is not blended: each pixel has it as its own centre does
//       (LightsOnGrid2), so that borders of beams and shadows are where they are; infinite at a light
// Where to draw is decided in doubles, but for (4).
class LightPixels2 {
 public:
  // walls: the scene, or null: none; it is not needed afterwards. REQUIRES across, up > 0, else throws
  // ContractViolation; the grid outlives this. (4) does not hold: the scene has no lights, or they count as other
  // light.
  LightPixels2(const IlluminationGrid2& grid, std::uint32_t across, std::uint32_t up, const Scene2* walls);
  // The same with the scene as walls, and its lights. REQUIRES that it outlives this; light of with_lights().
  LightPixels2(const PreparedScene2& prepared, const IlluminationGrid2& grid, std::uint32_t across, std::uint32_t up);

  std::uint32_t width() const { return grid_.grid.nx * across_; }
  std::uint32_t height() const { return grid_.grid.ny * up_; }
  // Pixels of a row of cells, in C order (up, width, channels), the lowest row of pixels first. Callable from many
  // threads at once. REQUIRES iy < ny of the grid.
  std::vector<double> row_of_cells(std::uint32_t iy) const;

 private:
  // Where the pixels of a cell lie along one side, in cells, and the centres that they lie between.
  struct Places {
    std::vector<double> at, share;  // of the centre after, in the two
    std::size_t half = 0;           // how many lie before the centre of the cell
  };
  static Places places(std::uint32_t cell, std::uint32_t pixels);
  void mark_cell(std::uint32_t ix, std::uint32_t iy, const Places& x, const Places& y, std::uint8_t* barred) const;
  void blend(std::uint32_t ix, std::uint32_t iy, const Places& x, const Places& y, std::size_t i, std::size_t j,
             std::uint8_t barred, double* pixel) const;

  void read_walls(const Scene2& walls);

  std::shared_ptr<const IlluminationGrid2> blended_;  // without lights, where there are some
  std::shared_ptr<const LightsOnGrid2> lights_;       // of the pixels
  const IlluminationGrid2& grid_;                     // that is blended
  std::uint32_t across_, up_;
  bool has_gaps_;                                 // some values are NaN
  std::vector<Wall2> walls_;                      // in cells from the lower left corner of the grid
  std::vector<std::uint32_t> near_begin_, near_;  // by cell: walls that come near it
};

}  // namespace hottel

// Light between the faces in the plane as numbers, on a grid of cells.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/plane/scene/scene.h"

namespace hottel {

// What the value of a cell is.
//
//   kPoint          the mean irradiance at its centre, over all directions, that of lights included         [W/m²]
//   kAverage        the mean of that over the free part of the cell, with a proven bound                    [W/m²]
//   kInverseSquare  the sum of length * radiosity / distance² over elements, each times the part of it that is seen:
//                   the formula of some programs, to compare with                                           [W/m³]
//
// The second and the third are refused in a scene with lights (RequestError): theirs would be missing.
enum class LightKind2 : unsigned char { kPoint, kAverage, kInverseSquare };

// The word for it: "point", "average", "inverse-square".
const char* to_string(LightKind2 kind);
// The kind of a word; nothing for other words.
std::optional<LightKind2> light_kind_2(std::string_view word);

// A value for each cell and channel, in C order (ny, nx, channels): index 0 is the lowest y, the lowest x. NaN in all
// channels: the centre of the cell is in a solid (of averages: all of it is), or the scene is closed and the centre
// sees no face with a material. Infinite where the centre is a light.
struct IlluminationGrid2 {
  Grid2 grid;
  std::uint32_t channels = 1;
  std::vector<double> values;

  // REQUIRES ix < grid.nx, iy < grid.ny, channel < channels.
  double at(std::uint32_t ix, std::uint32_t iy, std::uint32_t channel = 0) const {
    return values[(std::size_t{iy} * grid.nx + ix) * channels + channel];
  }
  // All channels of cell iy * nx + ix.
  std::span<double> of_cell(std::size_t cell) { return {values.data() + cell * channels, channels}; }
};

// Returns the region that the scene takes as nx times ny cells: the first of its own grids', else its bounding box. A
// box without width or height is widened to that of one cell, or to 1 where both are missing.
Grid2 grid_over(const Scene2& scene, std::uint32_t nx, std::uint32_t ny);

// Returns the first of the scene's own grids if it has one, else square cells over its bounding box: `longer` of them
// along its longer side, from its lower left corner; in the other direction as many as cover it.
Grid2 default_grid(const Scene2& scene, std::uint32_t longer = 256);

// Light on a grid, and the proven bound on its values where there is one: for "average" alone, of these radiosities.
struct SolvedLight2 {
  IlluminationGrid2 grid;
  std::optional<double> max_error{};
  double seconds = 0;  // what it took, as a simulation measures it
};

}  // namespace hottel

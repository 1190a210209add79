// Light between the faces in space, on a planar grid of points, or in a volume of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "geometry/element.h"
#include "geometry/space/scene/scene.h"
#include "solver/radiosity/radiosity_solution.h"

namespace hottel {

struct PreparedScene3;

// A value for each cell and channel, in C order (nv, nu, channels), of a volume (nw, nv, nu, channels): cells in the
// order of cell_centre(). NaN in all channels: the centre of the cell is in a solid, or the scene is closed and the
// centre sees no face with a material.
struct IlluminationGrid3 {
  Grid3 grid;
  std::uint32_t channels = 1;
  std::vector<double> values;
  double seconds = 0;  // what it took
  // By cell, of averages: proven, no channel's value is farther than this from the real number, for the radiosities as
  // given. 0 where the value is NaN. Empty of light at points.
  std::vector<double> errors{};

  bool is_average() const { return !errors.empty(); }
  // The largest of the errors; nothing of light at points.
  std::optional<double> max_error() const;

  // REQUIRES a planar grid, iu < grid.nu, iv < grid.nv, channel < channels. Of a volume the value of cell_centre(k) is
  // values[k * channels + channel].
  double at(std::uint32_t iu, std::uint32_t iv, std::uint32_t channel = 0) const {
    return values[(std::size_t{iv} * grid.nu + iu) * channels + channel];
  }
  // The channels of a cell. REQUIRES cell < grid.cells().
  std::span<double> of_cell(std::size_t cell) { return std::span(values).subspan(cell * channels, channels); }
};

// Returns a grid with what `light_at` writes at the centre of each cell, on all threads; what it leaves is NaN.
// progress: fraction done; may throw to stop. REQUIRES that cells do not depend on each other.
IlluminationGrid3 light_in_cells(const Grid3& grid, std::uint32_t channels,
                                 const std::function<void(const Point3& centre, std::span<double> light)>& light_at,
                                 const std::function<void(double)>& progress = {});

// Returns the mean irradiance at the centre of each cell: 1/4 pi times the integral over all directions of the
// radiosity seen there, which is the mean over them; and that of lights, I / (4 r^2) where they reach. [unit: that of
// radiosity]
//
//   (1) what is seen is decided exactly, from the exact centre (VisibilityMap3); solid angles are in doubles. A cell
//       does not depend on the others
//   (2) directions to the sky carry its emission; black sides are 0. A centre on a face sees both half spaces
//   (3) without lights never below the least nor above the largest radiosity seen but for rounding: some 1e-15 of it
//   (4) the same bits for any number of threads, and whoever takes part (cell_crew.h)
//
// progress: fraction done; may throw to stop. Throws Interrupted when asked to stop. REQUIRES the solution of the
// scene's matrix by that granularity. COST: that of a map a cell, and for each face that is seen and divided the
// product of its fragments and elements.
IlluminationGrid3 illuminate_points(const PreparedScene3& prepared, Granularity granularity,
                                    const RadiositySolution& solution, const Grid3& grid,
                                    const std::function<void(double)>& progress = {});

}  // namespace hottel

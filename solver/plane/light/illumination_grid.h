// How light in space is computed at the cells of a grid.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "solver/plane/light/light_rows.h"
#include "solver/plane/light/light_values.h"
#include "solver/plane/light/lit_region.h"
#include "solver/plane/light/sent_out.h"

namespace hottel {

// Returns the mean irradiance at the centre of each cell (PointLights2), of several solutions in one look: one grid for
// each.
//
//   (1) visibility is exact, from the exact centre; a cell does not depend on the others
//   (2) bit-identical for any number of threads, and whatever other solutions there are
// progress: fraction done; may throw to stop. Throws Interrupted when asked to stop.
// REQUIRES: what is sent out by the elements of this table, which is the scene's; at least one cell, min < max.
// COST: about 0.5 µs a cell and core in a furnished apartment of 400 edges, 8 µs where a cell sees 250 vertices; about
// 1 ns more for what is seen of each further solution.
std::vector<IlluminationGrid2> illuminate_points(const PreparedScene2& prepared, const Grid2& grid,
                                                 const ElementTable2& table, std::span<const SentOut2> solutions,
                                                 const std::function<void(double)>& progress = {});
// The same for one solution.
IlluminationGrid2 illuminate_points(const PreparedScene2& prepared, const Grid2& grid, const ElementTable2& table,
                                    const SentOut2& sent_out, const std::function<void(double)>& progress = {});

// The same for a solution of a matrix of the scene by that granularity. Others may take part (cell_crew.h): the same
// bits.
IlluminationGrid2 illuminate_points(const PreparedScene2& prepared, Granularity granularity,
                                    const RadiositySolution& solution, const Grid2& grid,
                                    const std::function<void(double)>& progress = {});

// The same from rows that were kept of this grid, without a look; the same bits. Throws ContractViolation unless there
// is a row for each cell.
IlluminationGrid2 illuminate_points(const LightRows2& rows, const Grid2& grid, const SentOut2& sent_out);

// What the lights of a scene add to the light of a grid.
//
// REQUIRES that prepared outlives it. Any number of threads may ask at once.
class LightsOnGrid2 {
 public:
  LightsOnGrid2(const PreparedScene2& prepared, const Grid2& grid);

  bool is_empty() const { return lit_.is_empty(); }  // the scene has no lights
  // Adds the direct mean irradiance at the centre of each cell of a row, I / (pi r) where it is reached (lit_region.h):
  // infinite at a light itself; NaN stays. row: (nx, channels). COST: about 0.1 µs a cell and light.
  void add_to_row(std::uint32_t iy, std::uint32_t channels, std::span<double> row) const;

 private:
  const PreparedScene2& prepared_;
  Grid2 grid_;
  LitRegions2 lit_;
  std::vector<EyeCoordinate2> columns_;  // of the centres
  std::vector<double> ways_;             // by column and light: the way from there, in integer form
};

// The light of a grid, and what the lights of the scene add to it. The same where there are none.
IlluminationGrid2 with_lights(const PreparedScene2& prepared, IlluminationGrid2 light);

// The light of a grid without what lights added; NaN where that was infinite. The same where there are none.
IlluminationGrid2 without_lights(const PreparedScene2& prepared, IlluminationGrid2 light);

// Returns the source formula instead: sum over elements j of H_j B_j / r_j², with H_j the fraction of the element that
// the centre sees (exact visibility) and r_j the distance to its middle, at least half the shorter side of a cell.
// An approximation without the cosine and with the dimension of space, to be compared: it is not bounded by the largest
// radiosity and depends on how edges are divided. The sky, which is at no distance, gives nothing; an edge on which the
// centre lies is not seen from there. NaN where the centre lies in a solid.
// by_element: as for SentOut2. [unit: that of radiosity / length²]
// Throws RequestError when a value is beyond the range of doubles.
IlluminationGrid2 illuminate_inverse_square(const PreparedScene2& prepared, const Grid2& grid,
                                            const ElementTable2& table, std::span<const double> by_element,
                                            std::uint32_t channels, const std::function<void(double)>& progress = {});

}  // namespace hottel

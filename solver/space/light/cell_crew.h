// Other processes that light the cells of a grid in space together with this one.
#pragma once

#include <cstddef>
#include <span>

#include "geometry/element.h"
#include "geometry/shared_work.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "solver/lit_cells.h"
#include "solver/radiosity/radiosity_solution.h"
#include "solver/space/light/sent_out.h"

namespace hottel {

// What is shared of illuminate_points(): a task is a cell. Of the solution only radiosities count.
struct CellJob3 {
  const PreparedScene3& prepared;
  Granularity granularity;  // of the solution
  const RadiositySolution& solution;
  const Grid3& grid;
  WorkSizes tasks;
};

// Who takes part in the light of grids. What they find must be what LightOfElements3 finds, bit for bit.
using CellCrew3 = WorkCrew<CellJob3, LitCells>;

// What elements send to cells of a grid.
//
//   (1) a cell does not depend on the others: the same bits in any process that has the same scene and radiosities
// REQUIRES that all but the grid outlives it. COST: that of a map a cell. For several threads at once.
class LightOfElements3 {
 public:
  LightOfElements3(const PreparedScene3& prepared, Granularity granularity, const RadiositySolution& solution,
                   const Grid3& grid);

  // Writes the mean over all directions at the centre of a cell, by channel; leaves what is in a solid, or outside a
  // closed scene.
  void mean(std::size_t cell, std::span<double> result) const;
  // These of some cells, on all threads. REQUIRES cells of the grid.
  LitCells lit(const WorkRange& cells) const;

 private:
  const PreparedScene3& prepared_;
  const Grid3 grid_;
  const std::size_t channels_;
  const SentOut3 sent_out_;
};

}  // namespace hottel

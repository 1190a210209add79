// Other processes that light the cells of a grid in the plane together with this one.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "geometry/element.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/shared_work.h"
#include "solver/lit_cells.h"
#include "solver/radiosity/radiosity_solution.h"

namespace hottel {

// What is shared of illuminate_points(): a task is a band of cells (CellViews2). Of the solution only radiosities
// count.
struct CellJob2 {
  const PreparedScene2& prepared;
  Granularity granularity;  // of the solution
  const RadiositySolution& solution;
  const Grid2& grid;
  WorkSizes tasks;
};

// Who takes part in the light of grids. What they find must be what LightOfElements2 finds, bit for bit.
using CellCrew2 = WorkCrew<CellJob2, LitCells>;

// What elements send to cells of a grid.
//
//   (1) a cell does not depend on the others: the same bits in any process that has the same scene and radiosities
// REQUIRES that the scene outlives it. COST: that of illuminate_points().
class LightOfElements2 {
 public:
  LightOfElements2(const PreparedScene2& prepared, Granularity granularity, const RadiositySolution& solution,
                   const Grid2& grid);
  ~LightOfElements2();

  std::size_t bands() const;
  // The first cell of a band; of bands(), the number of cells. REQUIRES band <= bands().
  std::size_t first_cell(std::size_t band) const;
  // Writes the light of some bands, by cell and channel, on all threads. Throws Interrupted when asked to stop.
  // REQUIRES bands that there are, and as many values.
  void light(const WorkRange& bands, std::span<double> values) const;
  // The same with memory of its own.
  LitCells lit(const WorkRange& bands) const;

 private:
  struct Inside;
  std::unique_ptr<const Inside> inside_;
};

}  // namespace hottel

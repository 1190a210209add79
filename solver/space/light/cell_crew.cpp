#include "solver/space/light/cell_crew.h"

#include <limits>

#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"

namespace hottel {

LightOfElements3::LightOfElements3(const PreparedScene3& prepared, Granularity granularity,
                                   const RadiositySolution& solution, const Grid3& grid)
    : prepared_(prepared),
      grid_(grid),
      channels_(solution.channels.size()),
      sent_out_(prepared, granularity, solution) {}

void LightOfElements3::mean(std::size_t cell, std::span<double> result) const {
  const Point3 centre = cell_centre(grid_, cell);
  if (!prepared_.arrangement().solids().around(centre)) sent_out_.mean(centre, result);
}

LitCells LightOfElements3::lit(const WorkRange& cells) const {
  HOTTEL_REQUIRE(cells.begin <= cells.end && cells.end <= grid_.cells());
  LitCells lit{cells, std::vector<double>(cells.size() * channels_, std::numeric_limits<double>::quiet_NaN())};
  parallel_for(cells.size(),
               [&](std::size_t k) { mean(cells.begin + k, std::span(lit.values).subspan(k * channels_, channels_)); });
  return lit;
}

}  // namespace hottel

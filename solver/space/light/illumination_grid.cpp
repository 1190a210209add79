#include "solver/space/light/illumination_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "geometry/space/prepared/prepared_scene.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "kernel/support/progress_count.h"
#include "kernel/support/stopwatch.h"
#include "solver/space/light/cell_crew.h"
#include "solver/space/light/scene_lights.h"

namespace hottel {
namespace {

IlluminationGrid3 unlit(const Grid3& grid, std::uint32_t channels) {
  return {grid, channels, std::vector<double>(grid.cells() * channels, std::numeric_limits<double>::quiet_NaN())};
}

void take(const LitCells& lit, IlluminationGrid3& result) {
  HOTTEL_REQUIRE(lit.tasks.end <= result.grid.cells() && lit.values.size() == lit.tasks.size() * result.channels);
  std::ranges::copy(lit.values, result.values.begin() + static_cast<std::ptrdiff_t>(lit.tasks.begin * result.channels));
}

}  // namespace

std::optional<double> IlluminationGrid3::max_error() const {
  if (errors.empty()) return std::nullopt;
  return *std::ranges::max_element(errors);
}

IlluminationGrid3 light_in_cells(const Grid3& grid, std::uint32_t channels,
                                 const std::function<void(const Point3& centre, std::span<double> light)>& light_at,
                                 const std::function<void(double)>& progress) {
  Stopwatch watch;
  IlluminationGrid3 result = unlit(grid, channels);
  ProgressCount count(progress, grid.cells());
  parallel_for(
      grid.cells(),
      [&](std::size_t cell) {
        light_at(cell_centre(grid, cell), result.of_cell(cell));
        count.add(1);
      },
      4);
  result.seconds = watch.lap();
  return result;
}

IlluminationGrid3 illuminate_points(const PreparedScene3& prepared, Granularity granularity,
                                    const RadiositySolution& solution, const Grid3& grid,
                                    const std::function<void(double)>& progress) {
  Stopwatch watch;
  IlluminationGrid3 result = unlit(grid, static_cast<std::uint32_t>(solution.channels.size()));
  const LightOfElements3 elements(prepared, granularity, solution, grid);
  const SceneLights3 lights(prepared);
  const CellJob3 job{prepared, granularity, solution, grid, {.count = grid.cells(), .least = 4, .most = 256}};
  ProgressCount progress_count(progress, grid.cells());
  take_all_turns(*begin_shared<LitCells>(job), grid.cells(), threads_allowed(), [&](const WorkTurn<LitCells>& turn) {
    if (turn.there) take(*turn.there, result);
    const WorkRange& cells = turn.there ? turn.there->tasks : turn.here;
    for (std::size_t cell = cells.begin; cell < cells.end; ++cell) {
      const std::span<double> light = result.of_cell(cell);
      if (!turn.there) elements.mean(cell, light);
      if (!std::isnan(light.front())) lights.add(cell_centre(grid, cell), light);
      progress_count.add();
    }
  });
  result.seconds = watch.lap();
  return result;
}

}  // namespace hottel

#include "solver/space/light/illumination_grid.h"

#include <algorithm>
#include <limits>
#include <span>

#include "geometry/space/prepared/prepared_scene.h"
#include "kernel/support/parallel.h"
#include "kernel/support/progress_count.h"
#include "kernel/support/stopwatch.h"
#include "solver/space/light/scene_lights.h"
#include "solver/space/light/sent_out.h"

namespace hottel {

std::optional<double> IlluminationGrid3::max_error() const {
  if (errors.empty()) return std::nullopt;
  return *std::ranges::max_element(errors);
}

Point3 cell_centre(const Grid3& grid, std::size_t cell) {
  const auto middle = [](std::size_t k, std::size_t count) -> Rational {
    return Rational(2 * k + 1) / Rational(2 * count);
  };
  const std::size_t layer = std::size_t{grid.nu} * grid.nv, in_layer = cell % layer;
  return place_in(grid, middle(in_layer % grid.nu, grid.nu), middle(in_layer / grid.nu, grid.nv),
                  middle(cell / layer, grid.nw));
}

IlluminationGrid3 light_in_cells(const Grid3& grid, std::uint32_t channels,
                                 const std::function<void(const Point3& centre, std::span<double> light)>& light_at,
                                 const std::function<void(double)>& progress) {
  Stopwatch watch;
  IlluminationGrid3 result{grid, channels, {}};
  const std::size_t cells = grid.cells();
  result.values.assign(cells * channels, std::numeric_limits<double>::quiet_NaN());
  ProgressCount count(progress, cells);
  parallel_for(
      cells,
      [&](std::size_t cell) {
        light_at(cell_centre(grid, cell), std::span(result.values).subspan(cell * channels, channels));
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
  const SentOut3 sent_out(prepared, granularity, solution);
  const SceneLights3 lights(prepared);
  IlluminationGrid3 result = light_in_cells(
      grid, static_cast<std::uint32_t>(solution.channels.size()),
      [&](const Point3& centre, std::span<double> light) {
        if (prepared.arrangement().solids().around(centre)) return;
        sent_out.mean(centre, light);
        lights.add(centre, light);
      },
      progress);
  result.seconds = watch.lap();
  return result;
}

}  // namespace hottel

#include "cli/compare_grid.h"

#include <array>
#include <cmath>

#include "io/foreign/foreign_grid.h"
#include "io/results/grid_report.h"
#include "kernel/support/counted.h"
#include "solver/compare/grid_errors.h"
#include "solver/plane/light/illumination_grid.h"
#include "solver/space/light/illumination_grid.h"
#include "viewer/picture/grid_error_picture.h"

namespace hottel {
namespace {

std::string cells_text(const ForeignGrid& grid) { return fmt::format("{}x{}", grid.nx, grid.ny); }

void require_channels(const ForeignGrid& grid, const RadiositySolution& solution) {
  if (grid.channels == solution.channels.size()) return;
  throw InputError({grid.file, 0},
                   fmt::format("has {} a cell, and the light of the scene {}", counted(grid.channels, "value"),
                               solution.channels.size() == 1 ? "one" : "three: r, g, b"));
}

JudgedGrid judged(const ForeignGrid& foreign, std::span<const double> exact, const RadiositySolution& solution,
                  const GridPlace& place) {
  const GridValues found{foreign.ny, foreign.nx, foreign.channels, foreign.values},
      right{foreign.ny, foreign.nx, foreign.channels, exact};
  const std::vector<GridErrors> errors = grid_errors(found, right);
  return {grid_csv(errors, solution.channel_names, place), grid_error_picture(found, right, foreign.file, place),
          grid_sentences(errors, solution.channel_names, place, grid_reading(found, right))};
}

}  // namespace

JudgedGrid judge_grid(const std::string& file, const MethodComparison2& comparison) {
  const RadiositySolution& solution = comparison.required_solution();
  const ForeignGrid foreign = read_foreign_grid(file);
  require_channels(foreign, solution);
  const PreparedScene2& prepared = comparison.prepared();
  const Grid2 grid = grid_of(prepared.scene, cells_text(foreign));
  const std::array<double, 2> min = to_doubles(grid.min), max = to_doubles(grid.max);
  if (foreign.region)
    for (std::size_t k = 0; k < 2; ++k) {
      const double allowed = 1e-9 * (max[k] - min[k]);
      if (std::abs((*foreign.region)[0][k] - min[k]) > allowed || std::abs((*foreign.region)[1][k] - max[k]) > allowed)
        throw InputError(
            {file + ".json", 0}, "says that the grid lies elsewhere than that of the scene",
            {"the scene may say where: \"grid\": {\"min\": [x, y], \"max\": [x, y], \"cells\": [nx, ny]}"});
    }
  const ElementTable2 table(prepared.scene, prepared.arrangement, prepared.division, Granularity::kElement);
  const IlluminationGrid2 exact = with_lights(
      prepared, illuminate_points(prepared, grid, table, sent_out_2(table, solution, prepared.scene.sky_emission)));
  return judged(foreign, exact.values, solution,
                {{min[0], min[1], 0}, {max[0] - min[0], 0, 0}, {0, max[1] - min[1], 0}, grid.nx, grid.ny, false});
}

JudgedGrid judge_grid(const std::string& file, const MethodComparison3& comparison) {
  const RadiositySolution& solution = comparison.required_solution();
  const ForeignGrid foreign = read_foreign_grid(file);
  require_channels(foreign, solution);
  const PreparedScene3& prepared = comparison.prepared();
  const std::optional<Grid3> grid = grid_of(prepared.scene, cells_text(foreign));
  const IlluminationGrid3 exact = illuminate_points(prepared, Granularity::kElement, solution, *grid);
  const auto doubles = [](const auto& p) { return std::array{to_double(p.x), to_double(p.y), to_double(p.z)}; };
  return judged(foreign, exact.values, solution,
                {doubles(grid->origin), doubles(grid->u), doubles(grid->v), grid->nu, grid->nv, true});
}

}  // namespace hottel

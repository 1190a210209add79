#include "cli/compare_grid.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <vector>

#include "geometry/grid_names.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "io/external/external_grid.h"
#include "io/results/grid_report.h"
#include "io/results/space/light_region.h"
#include "kernel/support/counted.h"
#include "solver/compare/grid_errors.h"
#include "solver/plane/light/illumination_grid.h"
#include "solver/space/light/illumination_grid.h"
#include "viewer/picture/grid_error_picture.h"

namespace hottel {
namespace {

// Throws InputError where the scene says how many cells there are, and the file has others.
void require_cells(const ExternalGrid& grid, std::uint32_t nx, std::uint32_t ny) {
  if (grid.nx == nx && grid.ny == ny) return;
  throw InputError({grid.file, 0},
                   fmt::format("has the shape ({}, {}), and the grid of the scene ({}, {}){}", grid.ny, grid.nx, ny, nx,
                               grid.nx == ny && grid.ny == nx ? ": the axes are exchanged" : ""),
                   {"(ny, nx): rows along the first index, the lowest first"});
}

void require_few_cells(const ExternalGrid& grid, std::uint32_t most) {
  if (std::max(grid.nx, grid.ny) > most || std::min(grid.nx, grid.ny) < 1)
    throw InputError({grid.file, 0}, fmt::format("has {} x {} cells, where a grid has from 1 to {} along an axis",
                                                 grid.nx, grid.ny, most));
}

void require_channels(const ExternalGrid& grid, const RadiositySolution& solution) {
  const std::size_t channels = solution.channels.size();
  if (grid.channels == channels) return;
  const bool is_one = channels == 1;
  throw InputError(
      {grid.file, 0},
      fmt::format("has {} a cell, and the light of the scene {}", counted(grid.channels, "value"),
                  is_one ? "one" : fmt::format("{}: {}", channels, fmt::join(solution.channel_names, ", "))),
      {fmt::format("its shape has to be ({}, {}{})", grid.ny, grid.nx, is_one ? "" : fmt::format(", {}", channels))});
}

JudgedGrid judged(const ExternalGrid& external, std::span<const double> exact, const RadiositySolution& solution,
                  const GridPlace& place, double beyond) {
  const GridValues found{external.ny, external.nx, external.channels, external.values},
      right{external.ny, external.nx, external.channels, exact};
  const std::vector<GridErrors> errors = grid_errors(found, right, beyond, external.digits);
  return {grid_csv(errors, solution.channel_names, place),
          grid_error_picture(found, right, external.file, place, "mean irradiance"),
          grid_sentences(errors, solution.channel_names, place, beyond, grid_reading(found, right))};
}

// The grid of a scene that a file of light is of: its only one, or the one whose name the file's ends in, as solve
// writes it: illumination-NAME.npy. REQUIRES grids.
template <class AnyGrid>
const AnyGrid& grid_of_file(const std::vector<AnyGrid>& grids, const std::string& file) {
  if (grids.size() == 1) return grids.front();
  const std::string stem = std::filesystem::path(file).stem().string();
  const AnyGrid* found = nullptr;
  for (const AnyGrid& grid : grids)  // of 'desk' and 'old-desk' the longer one
    if (stem.ends_with("-" + grid.name) && (found == nullptr || grid.name.size() > found->name.size())) found = &grid;
  if (found != nullptr) return *found;
  throw InputError({file, 0},
                   "is light on one of several grids, and its name does not say which: " + names_of_grids(grids),
                   {"call it illumination-NAME" + std::filesystem::path(file).extension().string()});
}

// The grid in the plane: the scene's own, which has the file's cells, or one over its surfaces.
Grid2 grid_of_file(const Scene2& scene, const ExternalGrid& external) {
  if (scene.grids.empty()) {
    require_few_cells(external, kMaxGridCells);
    return grid_over(scene, external.nx, external.ny);
  }
  const Grid2& own = grid_of_file(scene.grids, external.file);
  require_cells(external, own.nx, own.ny);
  return own;
}

}  // namespace

JudgedGrid judge_grid(const std::string& file, const MethodComparison2& comparison, double beyond) {
  const RadiositySolution& solution = comparison.required_solution();
  const ExternalGrid external = read_external_grid(file);
  require_channels(external, solution);
  const PreparedScene2& prepared = comparison.prepared();
  const Grid2 grid = grid_of_file(prepared.scene, external);
  const std::array<double, 2> min = to_doubles(grid.min), max = to_doubles(grid.max);
  if (external.region)
    for (std::size_t k = 0; k < 2; ++k) {
      const double allowed = 1e-9 * (max[k] - min[k]);
      if (std::abs((*external.region)[0][k] - min[k]) > allowed ||
          std::abs((*external.region)[1][k] - max[k]) > allowed)
        throw InputError(
            {name_beside(file), 0}, "says that the grid lies elsewhere than that of the scene",
            {"the scene may say where: \"grid\": {\"min\": [x, y], \"max\": [x, y], \"cells\": [nx, ny]}"});
    }
  return judged(external, exact_light_on(comparison, grid).values, solution,
                {{min[0], min[1], 0}, {max[0] - min[0], 0, 0}, {0, max[1] - min[1], 0}, grid.nx, grid.ny, false},
                beyond);
}

JudgedGrid judge_grid(const std::string& file, const MethodComparison3& comparison, double beyond) {
  const RadiositySolution& solution = comparison.required_solution();
  const PreparedScene3& prepared = comparison.prepared();
  if (prepared.scene.grids.empty())
    throw InputError({file, 0}, "is light on a grid, and the scene does not say where one lies",
                     {"\"grid\": {\"origin\": [x, y, z], \"u\": [x, y, z], \"v\": [x, y, z], \"cells\": [nu, nv]}"});
  const Grid3& grid = grid_of_file(prepared.scene.grids, file);
  if (grid.is_volume())
    throw InputError({file, 0}, "is light in a volume, and what is compared is light on planar grids",
                     {"compare its layers, each as a grid without \"w\""});
  const ExternalGrid external = read_external_grid(file);
  require_channels(external, solution);
  require_cells(external, grid.nu, grid.nv);
  if (external.region_in_space && !are_sides_of(*external.region_in_space, grid))
    throw InputError({name_beside(file), 0}, "says that the grid lies elsewhere than that of the scene",
                     {"\"origin\" is the corner of the first cell, \"u\" and \"v\" are the sides from there"});
  return judged(external, exact_light_on(comparison, grid).values, solution,
                {to_doubles(grid.origin), to_doubles(grid.u), to_doubles(grid.v), grid.nu, grid.nv, true}, beyond);
}

}  // namespace hottel

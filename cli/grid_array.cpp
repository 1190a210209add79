#include "cli/grid_array.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "cli/grid_exr.h"
#include "geometry/name.h"
#include "io/results/grid_file.h"
#include "io/results/npy.h"

namespace hottel {
namespace {

OutputFile& file_of_grid(const std::string& kind, const std::string& grid, SolveFiles& files) {
  return files.add(kind, grid_file(kind, grid));
}

}  // namespace

GridArray::GridArray(const std::string& stem, const std::string& grid, bool has_exr, SolveFiles& files)
    : npy_(file_of_grid(stem + ".npy", grid, files)), sidecar_(file_of_grid(stem + ".npy.json", grid, files)) {
  if (has_exr) exr_ = &file_of_grid(stem + ".exr", grid, files);
}

void GridArray::write(std::span<const std::size_t> shape, const std::vector<double>& values,
                      const std::vector<std::string>& channels, const std::string& unit, const std::string& about) {
  write_npy(shape, values, [this](std::string_view bytes) { npy_.write(bytes); });
  sidecar_.write(about);
  if (exr_) exr_->write(grid_exr({shape[1], shape[0], channels, values, unit, about}));
}

void note_cells_without_light(const std::string& grid, std::span<const double> light, const Streams& streams) {
  if (!std::ranges::all_of(light, [](double value) { return std::isnan(value); })) return;
  streams.note("no cell of the grid " + (grid.empty() ? "" : quoted_name(grid) + " ") +
               "has light: all lie in solids, or outside of the closed scene");
}

}  // namespace hottel

#include "solver/plane/light/cell_views.h"

#include <algorithm>
#include <span>
#include <vector>

#include "geometry/plane/visibility/tile_views.h"
#include "kernel/support/failure.h"
#include "kernel/support/interrupt.h"
#include "kernel/support/parallel.h"

namespace hottel {
namespace {

constexpr std::size_t kTilesBetweenReports = 128;

Rational centre(const Rational& min, const Rational& max, std::uint32_t index, std::uint32_t count) {
  return min + (max - min) * Rational(Integer(2 * static_cast<unsigned long>(index) + 1)) /
                   Rational(Integer(2 * static_cast<unsigned long>(count)));
}

}  // namespace

Point2 cell_centre(const Grid2& grid, std::uint32_t ix, std::uint32_t iy) {
  return {centre(grid.min.x, grid.max.x, ix, grid.nx), centre(grid.min.y, grid.max.y, iy, grid.ny)};
}

void for_each_cell_view(const PreparedScene2& prepared, const Grid2& grid, const std::function<void(double)>& progress,
                        const CellVisit2& visit) {
  HOTTEL_REQUIRE(grid.nx > 0 && grid.ny > 0 && grid.min.x < grid.max.x && grid.min.y < grid.max.y);
  const Vertices2& vertices = prepared.arrangement.vertices();
  const PointLocation2 location(vertices, prepared.arrangement.triangulation());
  std::vector<EyeCoordinate2> columns, rows;
  for (std::uint32_t ix = 0; ix < grid.nx; ++ix)
    columns.emplace_back(vertices, vertices.from_scene(cell_centre(grid, ix, 0)).x);
  for (std::uint32_t iy = 0; iy < grid.ny; ++iy)
    rows.emplace_back(vertices, vertices.from_scene(cell_centre(grid, 0, iy)).y);

  const auto tiles_along = [](std::uint32_t cells) { return (cells + EyeTile2::kSide - 1) / EyeTile2::kSide; };
  const auto tile_of = [](const std::vector<EyeCoordinate2>& all, std::size_t index) {
    const std::size_t first = index * EyeTile2::kSide;
    return std::span(all).subspan(first, std::min(EyeTile2::kSide, all.size() - first));
  };
  const std::size_t tiles_in_a_row = tiles_along(grid.nx), tiles = tiles_in_a_row * tiles_along(grid.ny);
  for (std::size_t begin = 0; begin < tiles; begin += kTilesBetweenReports) {
    const std::size_t end = std::min(tiles, begin + kTilesBetweenReports);
    parallel_ranges(end - begin, 1, [&](std::size_t from, std::size_t to) {
      thread_local TileViews2 views;  // its memory serves many tiles
      for (std::size_t index = begin + from; index < begin + to; ++index) {
        throw_if_interrupted();
        const std::size_t tile_x = index % tiles_in_a_row, tile_y = index / tiles_in_a_row;
        const EyeTile2 tile(vertices, tile_of(columns, tile_x), tile_of(rows, tile_y));
        views.look_around(location, tile);
        for (std::size_t row = 0; row < tile.rows(); ++row)
          for (std::size_t column = 0; column < tile.columns(); ++column) {
            const std::size_t k = row * EyeTile2::kSide + column;
            visit((tile_y * EyeTile2::kSide + row) * grid.nx + tile_x * EyeTile2::kSide + column, tile.eye(k),
                  views.location(k), views.view(k));
          }
      }
    });
    if (progress) progress(static_cast<double>(end) / static_cast<double>(tiles));
  }
}

}  // namespace hottel

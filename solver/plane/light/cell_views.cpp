#include "solver/plane/light/cell_views.h"

#include <algorithm>
#include <span>

#include "geometry/plane/visibility/tile_views.h"
#include "kernel/support/failure.h"
#include "kernel/support/interrupt.h"
#include "kernel/support/parallel.h"

namespace hottel {
namespace {

constexpr std::size_t kTilesInABand = 128;  // at least, where there are as many

Rational centre(const Rational& min, const Rational& max, std::uint32_t index, std::uint32_t count) {
  return min + (max - min) * Rational(Integer(2 * static_cast<unsigned long>(index) + 1)) /
                   Rational(Integer(2 * static_cast<unsigned long>(count)));
}

std::size_t quotient_up(std::size_t a, std::size_t b) { return (a + b - 1) / b; }

// Neighbours see less in common the more triangles there are between them; then large tiles only cost.
std::size_t tile_side(std::size_t cells, std::size_t triangles) {
  if (4 * cells >= 3 * triangles) return EyeTile2::kSide;
  return 10 * cells >= triangles ? EyeTile2::kSide / 2 : 1;
}

}  // namespace

Point2 cell_centre(const Grid2& grid, std::uint32_t ix, std::uint32_t iy) {
  return {centre(grid.min.x, grid.max.x, ix, grid.nx), centre(grid.min.y, grid.max.y, iy, grid.ny)};
}

CellTile2::CellTile2(const EyeTile2& eyes, const TileViews2& views, std::size_t first_cell, std::size_t cells_in_a_row)
    : eyes_(eyes),
      views_(views),
      columns_(eyes.columns()),
      rows_(eyes.rows()),
      first_cell_(first_cell),
      cells_in_a_row_(cells_in_a_row) {}

std::size_t CellTile2::in_tile(std::size_t k) const { return k / columns_ * EyeTile2::kSide + k % columns_; }
const Eye2& CellTile2::eye(std::size_t k) const { return eyes_.eye(in_tile(k)); }
const Location2& CellTile2::location(std::size_t k) const { return views_.location(in_tile(k)); }
const View2& CellTile2::view(std::size_t k) const { return views_.view(in_tile(k)); }

CellViews2::CellViews2(const PreparedScene2& prepared, const Grid2& grid)
    : vertices_(prepared.arrangement.vertices()), location_(vertices_, prepared.arrangement.triangulation()) {
  HOTTEL_REQUIRE(grid.nx > 0 && grid.ny > 0 && grid.min.x < grid.max.x && grid.min.y < grid.max.y);
  for (std::uint32_t ix = 0; ix < grid.nx; ++ix)
    columns_.emplace_back(vertices_, vertices_.from_scene(cell_centre(grid, ix, 0)).x);
  for (std::uint32_t iy = 0; iy < grid.ny; ++iy)
    rows_.emplace_back(vertices_, vertices_.from_scene(cell_centre(grid, 0, iy)).y);
  tile_side_ = tile_side(cells(), prepared.arrangement.triangulation().triangle_count());
  const std::size_t tiles_in_a_row = quotient_up(columns_.size(), tile_side_);
  rows_in_a_band_ = tile_side_ * quotient_up(kTilesInABand, tiles_in_a_row);
}

std::size_t CellViews2::first_cell(std::size_t band) const {
  return std::min(band * rows_in_a_band_, rows_.size()) * columns_.size();
}

void CellViews2::look_around(std::size_t band, const std::function<void(const CellTile2&)>& visit) const {
  const std::size_t first_row = band * rows_in_a_band_, row_count = std::min(rows_in_a_band_, rows_.size() - first_row);
  const auto of_tile = [this](std::span<const EyeCoordinate2> all, std::size_t index) {
    const std::size_t first = index * tile_side_;
    return all.subspan(first, std::min(tile_side_, all.size() - first));
  };
  const std::size_t tiles_in_a_row = quotient_up(columns_.size(), tile_side_);
  const std::size_t tiles = tiles_in_a_row * quotient_up(row_count, tile_side_);
  parallel_for(tiles, [&](std::size_t index) {
    thread_local TileViews2 views;  // its memory serves many tiles
    throw_if_interrupted();
    const std::size_t tile_x = index % tiles_in_a_row, tile_y = index / tiles_in_a_row;
    const EyeTile2 tile(vertices_, of_tile(columns_, tile_x),
                        of_tile(std::span(rows_).subspan(first_row, row_count), tile_y));
    views.look_around(location_, tile);
    const std::size_t first_cell = (first_row + tile_y * tile_side_) * columns_.size() + tile_x * tile_side_;
    visit(CellTile2(tile, views, first_cell, columns_.size()));
  });
}

void for_each_cell_view(const PreparedScene2& prepared, const Grid2& grid, const std::function<void(double)>& progress,
                        const CellVisit2& visit) {
  const CellViews2 views(prepared, grid);
  for (std::size_t band = 0; band < views.bands(); ++band) {
    views.look_around(band, [&](const CellTile2& tile) {
      for (std::size_t k = 0; k < tile.size(); ++k) visit(tile.cell(k), tile.eye(k), tile.location(k), tile.view(k));
    });
    if (progress) progress(static_cast<double>(band + 1) / static_cast<double>(views.bands()));
  }
}

}  // namespace hottel

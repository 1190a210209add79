#include "solver/illumination/cell_views_2.h"

#include <algorithm>
#include <vector>

#include "kernel/failure.h"
#include "kernel/interrupt.h"
#include "kernel/parallel.h"

namespace hottel {
namespace {

constexpr std::size_t kCellsBetweenReports = 1 << 12;
constexpr std::size_t kCellsInARow = 64;  // walked through from one to the next

Rational centre(const Rational& min, const Rational& max, std::uint32_t index, std::uint32_t count) {
  return min + (max - min) * Rational(Integer(2 * static_cast<unsigned long>(index) + 1)) /
                   Rational(Integer(2 * static_cast<unsigned long>(count)));
}

}  // namespace

ExactPoint2 cell_centre(const Grid2& grid, std::uint32_t ix, std::uint32_t iy) {
  return {centre(grid.min.x, grid.max.x, ix, grid.nx), centre(grid.min.y, grid.max.y, iy, grid.ny)};
}

void for_each_cell_view(const PreparedScene2& prepared, const Grid2& grid, const std::function<void(double)>& progress,
                        const CellVisit& visit) {
  HOTTEL_REQUIRE(grid.nx > 0 && grid.ny > 0 && grid.min.x < grid.max.x && grid.min.y < grid.max.y);
  const Vertices2& vertices = prepared.arrangement.vertices();
  const PointLocation2 location(vertices, prepared.arrangement.triangulation());
  std::vector<EyeCoordinate2> columns, rows;
  for (std::uint32_t ix = 0; ix < grid.nx; ++ix)
    columns.emplace_back(vertices, vertices.from_scene(cell_centre(grid, ix, 0)).x);
  for (std::uint32_t iy = 0; iy < grid.ny; ++iy)
    rows.emplace_back(vertices, vertices.from_scene(cell_centre(grid, 0, iy)).y);

  const std::size_t cells = std::size_t{grid.nx} * grid.ny;
  for (std::size_t begin = 0; begin < cells; begin += kCellsBetweenReports) {
    const std::size_t end = std::min(cells, begin + kCellsBetweenReports);
    parallel_ranges(end - begin, kCellsInARow, [&](std::size_t from, std::size_t to) {
      View2 view;
      HalfEdgeId near = -1;
      for (std::size_t cell = begin + from; cell < begin + to; ++cell) {
        throw_if_interrupted();
        const Eye2 eye(vertices, columns[cell % grid.nx], rows[cell / grid.nx]);
        const Location2 place = location.look_around(eye, view, near);
        visit(cell, eye, place, view);
      }
    });
    if (progress) progress(static_cast<double>(end) / static_cast<double>(cells));
  }
}

}  // namespace hottel

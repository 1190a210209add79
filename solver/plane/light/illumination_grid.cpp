#include "solver/plane/light/illumination_grid.h"

#include <algorithm>
#include <cmath>

#include "geometry/plane/scene/bounding_box.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "solver/plane/light/cell_crew.h"
#include "solver/plane/light/cell_views.h"

namespace hottel {
namespace {

std::uint32_t cells_to_cover(const Rational& length, const Rational& cell) {
  const Rational ratio = length / cell;
  const Integer whole = (ratio.get_num() + ratio.get_den() - 1) / ratio.get_den();
  return std::max<std::uint32_t>(1, static_cast<std::uint32_t>(whole.get_ui()));
}

IlluminationGrid2 empty_grid(const Grid2& grid, std::uint32_t channels) {
  IlluminationGrid2 result{grid, channels, {}};
  result.values.resize(std::size_t{grid.nx} * grid.ny * channels);
  return result;
}

}  // namespace

Grid2 grid_over(const Scene2& scene, std::uint32_t nx, std::uint32_t ny) {
  HOTTEL_REQUIRE(nx > 0 && ny > 0);
  if (!scene.grids.empty()) {
    const Grid2& own = scene.grids.front();
    return {own.min, own.max, nx, ny, own.name};
  }
  Box2 box = bounding_box(scene);
  if (box.width() == 0 && box.height() == 0) box.max.x += 1;
  if (box.width() == 0) box.max.x += box.height() / Rational(Integer(static_cast<unsigned long>(ny))) * nx;
  if (box.height() == 0) box.max.y += box.width() / Rational(Integer(static_cast<unsigned long>(nx))) * ny;
  return {box.min, box.max, nx, ny};
}

Grid2 default_grid(const Scene2& scene, std::uint32_t longer) {
  HOTTEL_REQUIRE(longer > 0);
  if (!scene.grids.empty()) return scene.grids.front();
  const Box2 box = bounding_box(scene);
  Rational extent = std::max(box.width(), box.height());
  if (extent == 0) extent = 1;
  const Rational cell = extent / Rational(Integer(static_cast<unsigned long>(longer)));
  const std::uint32_t nx = cells_to_cover(box.width(), cell), ny = cells_to_cover(box.height(), cell);
  return {box.min, {box.min.x + cell * nx, box.min.y + cell * ny}, nx, ny};
}

std::vector<IlluminationGrid2> illuminate_points(const PreparedScene2& prepared, const Grid2& grid,
                                                 const ElementTable2& table, std::span<const SentOut2> solutions,
                                                 const std::function<void(double)>& progress) {
  std::vector<IlluminationGrid2> result;
  for (const SentOut2& sent_out : solutions) result.push_back(empty_grid(grid, sent_out.channels()));
  for_each_light_row(prepared, grid, table, Blacks2::kLeftOut, progress, [&](std::size_t cell, const LightRow2& row) {
    for (std::size_t k = 0; k < solutions.size(); ++k) solutions[k].light(row, result[k].of_cell(cell));
  });
  return result;
}

IlluminationGrid2 illuminate_points(const PreparedScene2& prepared, const Grid2& grid, const ElementTable2& table,
                                    const SentOut2& sent_out, const std::function<void(double)>& progress) {
  return std::move(illuminate_points(prepared, grid, table, std::span(&sent_out, 1), progress).front());
}

IlluminationGrid2 illuminate_points(const PreparedScene2& prepared, Granularity granularity,
                                    const RadiositySolution& solution, const Grid2& grid,
                                    const std::function<void(double)>& progress) {
  const LightOfElements2 elements(prepared, granularity, solution, grid);
  IlluminationGrid2 result = empty_grid(grid, static_cast<std::uint32_t>(solution.channels.size()));
  const auto values_of = [&](const WorkRange& bands) {
    const std::size_t first = elements.first_cell(bands.begin), end = elements.first_cell(bands.end);
    return std::span(result.values).subspan(first * result.channels, (end - first) * result.channels);
  };
  const CellJob2 job{prepared, granularity, solution, grid, {elements.bands()}};
  std::size_t done = 0;
  // One turn after another: a band is lit by all threads.
  take_all_turns(*begin_shared<LitCells>(job), elements.bands(), 1, [&](const WorkTurn<LitCells>& turn) {
    const WorkRange& bands = turn.there ? turn.there->tasks : turn.here;
    HOTTEL_REQUIRE(bands.end <= elements.bands());
    const std::span<double> values = values_of(bands);
    if (turn.there) {
      HOTTEL_REQUIRE(turn.there->values.size() == values.size());
      std::ranges::copy(turn.there->values, values.begin());
    } else {
      elements.light(bands, values);
    }
    done += bands.size();
    if (progress) progress(static_cast<double>(done) / static_cast<double>(elements.bands()));
  });
  return result;
}

IlluminationGrid2 illuminate_points(const LightRows2& rows, const Grid2& grid, const SentOut2& sent_out) {
  IlluminationGrid2 result = empty_grid(grid, sent_out.channels());
  HOTTEL_REQUIRE(rows.cells() == std::size_t{grid.nx} * grid.ny);
  parallel_for(
      rows.cells(), [&](std::size_t cell) { sent_out.light(rows.row(cell), result.of_cell(cell)); }, 256);
  return result;
}

LightsOnGrid2::LightsOnGrid2(const PreparedScene2& prepared, const Grid2& grid)
    : prepared_(prepared), grid_(grid), lit_(prepared) {
  if (lit_.is_empty()) return;
  const Vertices2& vertices = prepared.arrangement.vertices();
  for (std::uint32_t ix = 0; ix < grid.nx; ++ix) {
    const Rational x = vertices.from_scene(cell_centre(grid, ix, 0)).x;
    for (std::size_t k = 0; k < lit_.count(); ++k) ways_.push_back(to_double(x - lit_.eye(k).exact().x));
    columns_.emplace_back(vertices, x);
  }
}

void LightsOnGrid2::add_to_row(std::uint32_t iy, std::uint32_t channels, std::span<double> row) const {
  if (lit_.is_empty()) return;
  HOTTEL_REQUIRE(iy < grid_.ny && row.size() == std::size_t{grid_.nx} * channels);
  const Vertices2& vertices = prepared_.arrangement.vertices();
  const EyeCoordinate2 y(vertices, vertices.from_scene(cell_centre(grid_, 0, iy)).y);
  std::vector<double> ways_y;
  for (std::size_t k = 0; k < lit_.count(); ++k) ways_y.push_back(to_double(y.exact() - lit_.eye(k).exact().y));
  for (std::size_t ix = 0; ix < grid_.nx; ++ix)
    lit_.add(Eye2(vertices, columns_[ix], y), std::span(ways_).subspan(ix * lit_.count(), lit_.count()), ways_y,
             row.subspan(ix * channels, channels));
}

IlluminationGrid2 with_lights(const PreparedScene2& prepared, IlluminationGrid2 light) {
  const LightsOnGrid2 lights(prepared, light.grid);
  if (lights.is_empty()) return light;
  const std::size_t width = std::size_t{light.grid.nx} * light.channels;
  parallel_for(light.grid.ny, [&](std::size_t iy) {
    lights.add_to_row(static_cast<std::uint32_t>(iy), light.channels,
                      std::span(light.values).subspan(iy * width, width));
  });
  return light;
}

IlluminationGrid2 without_lights(const PreparedScene2& prepared, IlluminationGrid2 light) {
  if (prepared.scene.lights.empty()) return light;
  const IlluminationGrid2 direct = with_lights(prepared, empty_grid(light.grid, light.channels));
  for (std::size_t k = 0; k < light.values.size(); ++k) light.values[k] -= direct.values[k];
  return light;
}

}  // namespace hottel

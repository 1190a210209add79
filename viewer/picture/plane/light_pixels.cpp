#include "viewer/picture/plane/light_pixels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/rounded_share.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr double kReach = 0.51;   // of a cell: how far from a cell a wall may matter to its pixels
constexpr double kOnWall = 1e-9;  // of a cell

// The first of the two centres that a place lies between, in cells; it may lie outside of the grid.
double centre_before(double place) { return std::floor(place - 0.5); }

bool has_nan(const IlluminationGrid2& grid) {
  return std::any_of(grid.values.begin(), grid.values.end(), [](double value) { return std::isnan(value); });
}

bool has_lights(const PreparedScene2& prepared) { return !prepared.scene.lights.empty(); }

}  // namespace

LightPixels2::LightPixels2(const IlluminationGrid2& grid, std::uint32_t across, std::uint32_t up, const Scene2* walls)
    : grid_(grid), across_(across), up_(up), has_gaps_(has_nan(grid)) {
  HOTTEL_REQUIRE(across > 0 && up > 0);
  if (walls) read_walls(*walls);
}

LightPixels2::LightPixels2(const PreparedScene2& prepared, const IlluminationGrid2& grid, std::uint32_t across,
                           std::uint32_t up)
    : blended_(has_lights(prepared) ? std::make_shared<const IlluminationGrid2>(without_lights(prepared, grid))
                                    : nullptr),
      grid_(blended_ ? *blended_ : grid),
      across_(across),
      up_(up),
      has_gaps_(has_nan(grid_)) {
  HOTTEL_REQUIRE(across > 0 && up > 0);
  read_walls(prepared.scene);
  const Grid2& cells = grid.grid;
  if (blended_)
    lights_ =
        std::make_shared<const LightsOnGrid2>(prepared, Grid2{cells.min, cells.max, cells.nx * across, cells.ny * up});
}

void LightPixels2::read_walls(const Scene2& walls) {
  const Grid2& cells = grid_.grid;
  const Rational wide = cells.max.x - cells.min.x, high = cells.max.y - cells.min.y;
  const RoundedShare share_x(cells.min.x, wide), share_y(cells.min.y, high);
  const auto x = [&](const Point2& p) { return share_x.of(p.x) * cells.nx; };
  const auto y = [&](const Point2& p) { return share_y.of(p.y) * cells.ny; };
  for (const auto& [from, to] : walls.edges) {
    const double ax = x(from), ay = y(from), bx = x(to), by = y(to);
    walls_.push_back({ax, ay, bx, by, kOnWall * std::hypot(bx - ax, by - ay)});
  }

  // Calls visit(cell) for each cell that the wall comes near: row by row, the part of the wall in reach of the row.
  const auto for_each_near = [&](const Wall2& wall, const auto& visit) {
    const auto index = [](double place, std::uint32_t count) {
      return static_cast<std::int64_t>(std::clamp(std::floor(place), -1.0, static_cast<double>(count)));
    };
    const double low = std::min(wall.ay, wall.by), top = std::max(wall.ay, wall.by);
    const std::int64_t first = std::max<std::int64_t>(0, index(low - kReach, cells.ny));
    const std::int64_t last = std::min<std::int64_t>(cells.ny - 1, index(top + kReach, cells.ny));
    for (std::int64_t iy = first; iy <= last; ++iy) {
      const double from = std::max(low, static_cast<double>(iy) - kReach);
      const double to = std::min(top, static_cast<double>(iy) + 1 + kReach);
      const auto at = [&](double height) {
        return wall.ay == wall.by ? wall.ax : std::lerp(wall.ax, wall.bx, (height - wall.ay) / (wall.by - wall.ay));
      };
      const double a = wall.ay == wall.by ? wall.ax : at(from), b = wall.ay == wall.by ? wall.bx : at(to);
      const std::int64_t left = std::max<std::int64_t>(0, index(std::min(a, b) - kReach, cells.nx));
      const std::int64_t right = std::min<std::int64_t>(cells.nx - 1, index(std::max(a, b) + kReach, cells.nx));
      for (std::int64_t ix = left; ix <= right; ++ix) visit(static_cast<std::size_t>(iy * cells.nx + ix));
    }
  };
  near_begin_.assign(std::size_t{cells.nx} * cells.ny + 1, 0);
  for (const Wall2& wall : walls_) for_each_near(wall, [&](std::size_t cell) { ++near_begin_[cell + 1]; });
  for (std::size_t cell = 1; cell < near_begin_.size(); ++cell) near_begin_[cell] += near_begin_[cell - 1];
  near_.resize(near_begin_.back());
  std::vector<std::uint32_t> next(near_begin_.begin(), near_begin_.end() - 1);
  for (std::uint32_t k = 0; k < walls_.size(); ++k)
    for_each_near(walls_[k], [&](std::size_t cell) { near_[next[cell]++] = k; });
}

LightPixels2::Places LightPixels2::places(std::uint32_t cell, std::uint32_t pixels) {
  Places result;
  for (std::uint32_t i = 0; i < pixels; ++i) {
    const double place = cell + (i + 0.5) / pixels;
    result.at.push_back(place);
    result.share.push_back(place - 0.5 - centre_before(place));
    if (centre_before(place) < cell) ++result.half;
  }
  return result;
}

// Sets a bit for each of the four centres around a pixel that is barred from it: 1 for left, 2 for right below, 4, 8
// above.
void LightPixels2::mark_cell(std::uint32_t ix, std::uint32_t iy, const Places& x, const Places& y,
                             std::uint8_t* barred) const {
  const Grid2& cells = grid_.grid;
  std::fill_n(barred, x.at.size() * y.at.size(), std::uint8_t{0});
  if (near_.empty()) return;
  const std::size_t own = std::size_t{iy} * cells.nx + ix;
  const std::span<const std::uint32_t> walls(near_.data() + near_begin_[own], near_.data() + near_begin_[own + 1]);
  if (walls.empty()) return;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const auto part = [](const Places& places, bool second) {
      const std::span<const double> at(places.at);
      return second ? at.subspan(places.half) : at.first(places.half);
    };
    const bool right = quarter % 2 == 1, above = quarter / 2 == 1;
    const PixelBlock2 block{part(x, right), part(y, above)};
    if (block.x.empty() || block.y.empty()) continue;
    std::uint8_t* const marks = barred + (above ? y.half : 0) * x.at.size() + (right ? x.half : 0);
    for (int corner = 0; corner < 4; ++corner) {
      const double cx = std::clamp(centre_before(block.x[0]) + corner % 2, 0.0, cells.nx - 1.0);
      const double cy = std::clamp(centre_before(block.y[0]) + corner / 2, 0.0, cells.ny - 1.0);
      mark_barred(walls_, walls, block, cx + 0.5, cy + 0.5, static_cast<std::uint8_t>(1 << corner), x.at.size(), marks);
    }
  }
}

void LightPixels2::blend(std::uint32_t ix, std::uint32_t iy, const Places& x, const Places& y, std::size_t i,
                         std::size_t j, std::uint8_t barred, double* pixel) const {
  const Grid2& cells = grid_.grid;
  const std::uint32_t channels = grid_.channels;
  const double right_share = x.share[i], top_share = y.share[j];
  const std::uint32_t left = ix - (i < x.half ? 1 : 0), below = iy - (j < y.half ? 1 : 0);  // may be -1
  const std::uint32_t columns[2] = {left == ix ? ix : ix == 0 ? 0 : left, std::min(left + 1, cells.nx - 1)};
  const std::uint32_t rows[2] = {below == iy ? iy : iy == 0 ? 0 : below, std::min(below + 1, cells.ny - 1)};
  const auto value_at = [&](std::uint32_t corner) {
    return grid_.values.data() + (std::size_t{rows[corner / 2]} * cells.nx + columns[corner % 2]) * channels;
  };
  bool sees_gap = false;
  for (std::uint32_t corner = 0; has_gaps_ && corner < 4; ++corner) {
    if (!std::isnan(*value_at(corner))) continue;
    sees_gap = sees_gap || (barred >> corner & 1) == 0;
    barred = static_cast<std::uint8_t>(barred | 1 << corner);
  }
  double total = 0;
  std::fill_n(pixel, channels, 0.0);
  for (const bool only_seen_counts : {false, true}) {  // the second time without weights
    for (std::uint32_t corner = 0; corner < 4; ++corner) {
      if (barred >> corner & 1) continue;
      const double weight =
          only_seen_counts ? 1
                           : (corner % 2 ? right_share : 1 - right_share) * (corner / 2 ? top_share : 1 - top_share);
      const double* value = value_at(corner);
      for (std::uint32_t c = 0; c < channels; ++c) pixel[c] += weight * value[c];
      total += weight;
    }
    if (total > 1e-3 || barred == 15) break;
    std::fill_n(pixel, channels, 0.0);
    total = 0;
  }
  if (barred == 15 && sees_gap) {  // on the side of a wall where there is no light, be its cell on the other one
    std::fill_n(pixel, channels, std::numeric_limits<double>::quiet_NaN());
    return;
  }
  if (barred == 15) {
    std::copy_n(grid_.values.data() + (std::size_t{iy} * cells.nx + ix) * channels, channels, pixel);
    return;
  }
  for (std::uint32_t c = 0; c < channels; ++c) pixel[c] /= total;
}

std::vector<double> LightPixels2::row_of_cells(std::uint32_t iy) const {
  const std::uint32_t channels = grid_.channels, nx = grid_.grid.nx;
  const std::size_t width = std::size_t{nx} * across_;
  std::vector<double> pixels(up_ * width * channels);
  const bool is_cells = across_ == 1 && up_ == 1 && near_.empty();
  const double* const values = grid_.values.data() + iy * width * channels;
  if (is_cells && !has_gaps_ && !lights_) return {values, values + width * channels};
  std::vector<std::uint8_t> barred(std::size_t{up_} * across_);
  const Places y = places(iy, up_);
  for (std::uint32_t ix = 0; ix < nx; ++ix) {
    if (is_cells && !std::isnan(values[ix * channels])) {  // its centre is the pixel
      std::copy_n(values + ix * channels, channels, pixels.data() + ix * channels);
      continue;
    }
    const Places x = places(ix, across_);
    mark_cell(ix, iy, x, y, barred.data());
    for (std::size_t j = 0; j < up_; ++j)
      for (std::size_t i = 0; i < across_; ++i)
        blend(ix, iy, x, y, i, j, barred[j * across_ + i],
              pixels.data() + (j * width + std::size_t{ix} * across_ + i) * channels);
  }
  const std::span all(pixels);
  for (std::uint32_t j = 0; lights_ && j < up_; ++j)
    lights_->add_to_row(iy * up_ + j, channels, all.subspan(j * width * channels, width * channels));
  return pixels;
}

}  // namespace hottel

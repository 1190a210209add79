#include "viewer/picture/light_pixels_2.h"

#include <algorithm>
#include <cmath>

#include "kernel/failure.h"
#include "kernel/rational.h"

namespace hottel {
namespace {

constexpr double kReach = 0.51;   // of a cell: how far from a cell a wall may matter to its pixels
constexpr double kOnWall = 1e-9;  // of a cell

double side(double ax, double ay, double bx, double by, double x, double y) {
  return (bx - ax) * (y - ay) - (by - ay) * (x - ax);
}

}  // namespace

LightPixels2::LightPixels2(const IlluminationGrid& grid, std::uint32_t across, std::uint32_t up, const Scene2* walls)
    : grid_(grid), across_(across), up_(up) {
  HOTTEL_REQUIRE(across > 0 && up > 0);
  if (!walls) return;
  const Grid2& cells = grid.grid;
  const Rational wide = cells.max.x - cells.min.x, high = cells.max.y - cells.min.y;
  const auto x = [&](const Point2& p) { return to_double((p.x - cells.min.x) / wide) * cells.nx; };
  const auto y = [&](const Point2& p) { return to_double((p.y - cells.min.y) / high) * cells.ny; };
  for (const Surface2& s : walls->surfaces) walls_.push_back({x(s.from), y(s.from), x(s.to), y(s.to)});

  // Calls visit(cell) for each cell that the wall comes near: row by row, the part of the wall in reach of the row.
  const auto for_each_near = [&](const Wall& wall, const auto& visit) {
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
  for (const Wall& wall : walls_) for_each_near(wall, [&](std::size_t cell) { ++near_begin_[cell + 1]; });
  for (std::size_t cell = 1; cell < near_begin_.size(); ++cell) near_begin_[cell] += near_begin_[cell - 1];
  near_.resize(near_begin_.back());
  std::vector<std::uint32_t> next(near_begin_.begin(), near_begin_.end() - 1);
  for (std::uint32_t k = 0; k < walls_.size(); ++k)
    for_each_near(walls_[k], [&](std::size_t cell) { near_[next[cell]++] = k; });
}

bool LightPixels2::is_barred(double x, double y, double to_x, double to_y, std::size_t cell) const {
  for (std::uint32_t k = near_begin_[cell]; k < near_begin_[cell + 1]; ++k) {
    const Wall& w = walls_[near_[k]];
    const double from_side = side(w.ax, w.ay, w.bx, w.by, x, y), to_side = side(w.ax, w.ay, w.bx, w.by, to_x, to_y);
    if (std::fabs(to_side) <= kOnWall * std::hypot(w.bx - w.ax, w.by - w.ay)) {
      // The centre lies on the line of the wall: what it has, both sides mixed, belongs to neither.
      if ((to_x - w.ax) * (to_x - w.bx) + (to_y - w.ay) * (to_y - w.by) <= kOnWall) return true;
      continue;
    }
    if ((from_side < 0) == (to_side < 0)) continue;
    if ((side(x, y, to_x, to_y, w.ax, w.ay) < 0) != (side(x, y, to_x, to_y, w.bx, w.by) < 0)) return true;
  }
  return false;
}

// x, y in cells.
void LightPixels2::blend(double x, double y, std::uint32_t ix, std::uint32_t iy, double* pixel) const {
  const Grid2& cells = grid_.grid;
  const std::uint32_t channels = grid_.channels;
  const double left = std::floor(x - 0.5), below = std::floor(y - 0.5);
  const double right_share = x - 0.5 - left, top_share = y - 0.5 - below;
  const std::size_t own = std::size_t{iy} * cells.nx + ix;
  const bool has_walls = !near_.empty() && near_begin_[own] < near_begin_[own + 1];
  double total = 0, seen = 0;
  std::fill_n(pixel, channels, 0.0);
  for (const bool only_seen_counts : {false, true}) {  // the second time without weights
    for (int corner = 0; corner < 4; ++corner) {
      const double cx = std::clamp(left + corner % 2, 0.0, cells.nx - 1.0);
      const double cy = std::clamp(below + corner / 2, 0.0, cells.ny - 1.0);
      const double* value =
          grid_.values.data() + (static_cast<std::size_t>(cy) * cells.nx + static_cast<std::size_t>(cx)) * channels;
      if (std::isnan(*value) || (has_walls && is_barred(x, y, cx + 0.5, cy + 0.5, own))) continue;
      const double weight =
          only_seen_counts ? 1
                           : (corner % 2 ? right_share : 1 - right_share) * (corner / 2 ? top_share : 1 - top_share);
      for (std::uint32_t c = 0; c < channels; ++c) pixel[c] += weight * value[c];
      total += weight;
      ++seen;
    }
    if (total > 1e-3 || seen == 0) break;
    std::fill_n(pixel, channels, 0.0);
    total = 0;
  }
  if (seen == 0) {
    std::copy_n(grid_.values.data() + own * channels, channels, pixel);
    return;
  }
  for (std::uint32_t c = 0; c < channels; ++c) pixel[c] /= total;
}

std::vector<double> LightPixels2::row_of_cells(std::uint32_t iy) const {
  const std::uint32_t channels = grid_.channels, nx = grid_.grid.nx;
  std::vector<double> pixels(std::size_t{up_} * nx * across_ * channels);
  double* pixel = pixels.data();
  for (std::uint32_t j = 0; j < up_; ++j)
    for (std::uint32_t ix = 0; ix < nx; ++ix)
      for (std::uint32_t i = 0; i < across_; ++i, pixel += channels)
        blend(ix + (i + 0.5) / across_, iy + (j + 0.5) / up_, ix, iy, pixel);
  return pixels;
}

}  // namespace hottel

#include "viewer/picture/space/grid_picture.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "kernel/support/failure.h"
#include "viewer/picture/cairo_canvas.h"
#include "viewer/picture/colour_map.h"
#include "viewer/picture/palette.h"
#include "viewer/picture/png_file.h"
#include "viewer/picture/raster.h"
#include "viewer/picture/tone_curve.h"

namespace hottel {
namespace {

constexpr double kLongerSide = 800;
constexpr double kGridFooter = 72;

// In a unit, which may be of any size.
double length(const Vector3& v, const Rational& unit) {
  return std::hypot(to_double(v.x / unit), to_double(v.y / unit), to_double(v.z / unit));
}

Rational largest_component(const Vector3& u, const Vector3& v) {
  Rational largest = 0;
  for (const Rational* component : {&u.x, &u.y, &u.z, &v.x, &v.y, &v.z})
    largest = std::max<Rational>(largest, abs(*component));
  return largest;
}

std::uint32_t pixels_a_cell(double wanted, std::uint32_t cells) {
  return static_cast<std::uint32_t>(
      std::clamp(std::round(wanted / cells), 1.0, std::floor(static_cast<double>(kMaxPictureSide) / cells)));
}

// In pixels.
struct CellSize {
  std::uint32_t across, up;
};

CellSize cell_size(const Grid3& grid, std::uint32_t wanted_width) {
  const Rational unit = largest_component(grid.u, grid.v);
  const double u = length(grid.u, unit), v = length(grid.v, unit);  // one of them at least 1
  const double width = wanted_width > 0 ? wanted_width : kLongerSide * (u / std::max(u, v));
  const double height = wanted_width > 0 ? width * (v / u) : kLongerSide * (v / std::max(u, v));
  return {pixels_a_cell(width, grid.nu), pixels_a_cell(height, grid.nv)};
}

// Each cell in the colour that pixel(cell) gives it, and so many rows left below.
template <class Pixels>
Raster cells_raster(const Grid3& grid, const CellSize& size, std::uint32_t footer, const Pixels& pixel) {
  const std::uint32_t height = size.up * grid.nv;
  Raster raster(size.across * grid.nu, height + footer);
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < raster.width; ++x)
      raster.pixels[std::size_t{y} * raster.width + x] =
          pixel(std::size_t{(height - 1 - y) / size.up} * grid.nu + x / size.across);
  return raster;
}

class GridPainter3 final : public LightPainter3 {
 public:
  explicit GridPainter3(const GridPicture3& picture) : picture_(picture) {}
  LightPicture3 paint(const IlluminationGrid3& light) const override { return {grid_picture_3(light, picture_)}; }

 private:
  GridPicture3 picture_;
};

}  // namespace

std::string grid_picture_3(const IlluminationGrid3& light, const GridPicture3& picture) {
  const CellSize size = cell_size(light.grid, picture.wanted_width);
  const ToneCurve tone(picture.tone, picture.exposure, light.values, light.channels);
  return png_file(cells_raster(light.grid, size, 0, [&](std::size_t cell) {
    const auto value = std::span(light.values).subspan(cell * light.channels, light.channels);
    return pixel_of(std::isnan(value[0]) ? palette::kUnlitSolid : tone(value));
  }));
}

std::string grid_picture_3(const Grid3& grid, const ShownValues& cells, std::uint32_t wanted_width) {
  HOTTEL_REQUIRE(cells.elements.size() == std::size_t{grid.nu} * grid.nv);
  const CellSize size = cell_size(grid, wanted_width);
  const double width = size.across * grid.nu, unit = std::clamp(width / 800, 0.35, 4.0);
  const auto footer = static_cast<std::uint32_t>(std::ceil(kGridFooter * unit));
  Raster raster = cells_raster(grid, size, footer, [&](std::size_t cell) {
    const std::optional<double>& value = cells.elements[cell];
    return pixel_of(value ? scale_colour(cells.scale, *value) : palette::kUnlitSolid);
  });
  CairoCanvas canvas(raster);
  const double top = raster.height - footer, margin = std::min(16 * unit, width / 12);
  canvas.fill_rectangle(Mark::kPaper, {0, top}, {width, top + footer}, palette::kPaper);
  draw_legend(canvas, cells.scale, cells.title, {margin, top + 6 * unit}, std::min(420 * unit, width - 2 * margin),
              unit);
  canvas.finish();
  return png_file(raster);
}

std::shared_ptr<const LightPainter3> grid_painter_3(const GridPicture3& picture) {
  return std::make_shared<GridPainter3>(picture);
}

}  // namespace hottel

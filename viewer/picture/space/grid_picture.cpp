#include "viewer/picture/space/grid_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "kernel/support/failure.h"
#include "viewer/picture/cairo_canvas.h"
#include "viewer/picture/colour_map.h"
#include "viewer/picture/frame_axes.h"
#include "viewer/picture/light_contours.h"
#include "viewer/picture/palette.h"
#include "viewer/picture/png_file.h"
#include "viewer/picture/raster.h"
#include "viewer/picture/scale_bar.h"
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

// Each cell in the colour that pixel(cell) gives it.
template <class Pixels>
Raster cells_raster(const Grid3& grid, const CellSize& size, const Pixels& pixel) {
  const std::uint32_t height = size.up * grid.nv;
  Raster raster(size.across * grid.nu, height);
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < raster.width; ++x)
      raster.pixels[std::size_t{y} * raster.width + x] =
          pixel(std::size_t{(height - 1 - y) / size.up} * grid.nu + x / size.across);
  return raster;
}

// A side of a grid as an axis: the coordinate of the scene that it runs along, else the way from the origin.
struct GridAxis {
  double begin = 0, end = 0;
  std::string name;
};

GridAxis axis_along(const Point3& origin, const Vector3& side, const char* name, const std::string& length_unit) {
  const auto named = [&](const char* axis) { return std::string(axis) + " [" + length_unit + "]"; };
  const std::array<const Rational*, 3> at{&origin.x, &origin.y, &origin.z}, way{&side.x, &side.y, &side.z};
  constexpr std::array<const char*, 3> kNames{"x", "y", "z"};
  for (std::size_t k = 0; k < 3; ++k)
    if (*way[(k + 1) % 3] == 0 && *way[(k + 2) % 3] == 0)
      return {to_double(*at[k]), to_double(Rational(*at[k] + *way[k])), named(kNames[k])};
  return {0, length(side, 1), named(name)};
}

// What contours go by: a number of each cell, NaN where there is none, and their levels.
struct LevelField {
  std::vector<double> cells;
  std::vector<double> levels;
};

// The cells around a place, along one side: it lies between the centres of `first` and `second`, so far on the way.
struct Between {
  std::size_t first, second;
  double way;
};

Between between(std::uint32_t pixel, std::uint32_t pixels_a_cell, std::uint32_t cells) {
  const double at = std::clamp((pixel + 0.5) / pixels_a_cell - 0.5, 0.0, cells - 1.0);
  const auto first = static_cast<std::size_t>(at);
  return {first, std::min<std::size_t>(first + 1, cells - 1), at - static_cast<double>(first)};
}

// Values at the centres of pixels, blended between four cells; where one of these has none, that of the cell itself.
PixelField blended_field(const Grid3& grid, const CellSize& size, const std::vector<double>& cells) {
  PixelField field{size.across * grid.nu, size.up * grid.nv, {}, {}};
  field.values.reserve(std::size_t{field.width} * field.height);
  const auto at = [&](std::size_t row, std::size_t column) { return cells[row * grid.nu + column]; };
  for (std::uint32_t y = field.height; y-- > 0;) {
    const Between v = between(y, size.up, grid.nv);
    for (std::uint32_t x = 0; x < field.width; ++x) {
      const Between u = between(x, size.across, grid.nu);
      const double blended = std::lerp(std::lerp(at(v.first, u.first), at(v.first, u.second), u.way),
                                       std::lerp(at(v.second, u.first), at(v.second, u.second), u.way), v.way);
      const double own = at(y / size.up, x / size.across);
      field.values.push_back(static_cast<float>(std::isnan(own) || std::isnan(blended) ? own : blended));
    }
  }
  return field;
}

// Cells with what stands around them: axes and a scale bar, a bar of colours below.
class GridSheet {
 public:
  GridSheet(const Grid3& grid, const GridPicture3& picture, const Raster& cells, bool has_bar, LevelField lines)
      : grid_(grid), picture_(picture), cells_(cells), lines_(std::move(lines)) {
    const double width = cells.width;
    unit_ = std::clamp(width / 800, picture.has_axes ? 0.6 : 0.35, 4.0);
    const auto room = [&](double units, bool is_there) {
      return is_there ? static_cast<std::uint32_t>(std::ceil(units * unit_)) : 0;
    };
    left_ = room(kLeft, picture.has_axes);
    right_ = room(kRight, picture.has_axes);
    top_ = room(kTop, picture.has_axes);
    bottom_ = room(kBottom, picture.has_axes);
    footer_ = room(kGridFooter, has_bar);
  }

  std::uint32_t width() const { return left_ + cells_.width + right_; }
  std::uint32_t height() const { return top_ + cells_.height + bottom_ + footer_; }
  void draw(PictureCanvas& canvas, const ShownValues* shown) const {
    canvas.fill_rectangle(Mark::kPaper, {0, 0}, {canvas.width(), canvas.height()}, palette::kPaper);
    canvas.image(Mark::kLight, from(), to(), cells_, false);
    draw_lines(canvas);
    if (picture_.has_axes) draw_axes(canvas);
    if (shown == nullptr) return;
    const double margin = std::min(16 * unit_, canvas.width() / 12);
    draw_legend(canvas, shown->scale, shown->title, {margin, height() - footer_ + 6 * unit_},
                std::min(420 * unit_, canvas.width() - 2 * margin), unit_);
  }

 private:
  static constexpr double kLeft = 78, kRight = 66, kTop = 34, kBottom = 62;

  Pixel from() const { return {double(left_), double(top_)}; }
  Pixel to() const { return {double(left_ + cells_.width), double(top_ + cells_.height)}; }
  void draw_lines(PictureCanvas& canvas) const {
    if (lines_.levels.empty()) return;
    const CellSize size{cells_.width / grid_.nu, cells_.height / grid_.nv};
    draw_light_contours(canvas, blended_field(grid_, size, lines_.cells), lines_.levels, std::min(size.across, size.up),
                        from(), std::max(unit_, 0.6));
  }
  void draw_axes(PictureCanvas& canvas) const {
    const GridAxis u = axis_along(grid_.origin, grid_.u, "u", picture_.length_unit);
    const GridAxis v = axis_along(grid_.origin, grid_.v, "v", picture_.length_unit);
    draw_frame_axes(canvas, {from(), to(), u.begin, u.end, v.begin, v.end, u.name, v.name}, unit_);
    draw_scale_bar(
        canvas, cells_.width / length(grid_.u, 1), picture_.length_unit,
        {.right = {to().x, to().y + 34 * unit_}, .room = std::min(190 * unit_, cells_.width / 4.0), .unit = unit_});
  }

  const Grid3& grid_;
  const GridPicture3& picture_;
  const Raster& cells_;
  LevelField lines_;
  double unit_ = 1;
  std::uint32_t left_ = 0, right_ = 0, top_ = 0, bottom_ = 0, footer_ = 0;
};

std::string sheet_file(const Grid3& grid, const GridPicture3& picture, const Raster& cells, LevelField lines,
                       const ShownValues* shown) {
  if (!picture.has_axes && shown == nullptr && lines.levels.empty()) return png_file(cells);
  const GridSheet sheet(grid, picture, cells, shown != nullptr, std::move(lines));
  CairoCanvas canvas(PictureFormat::kPng, sheet.width(), sheet.height());
  sheet.draw(canvas, shown);
  return canvas.finish();
}

LevelField level_field(std::span<const double> values, std::size_t channels, int contours) {
  LevelField field{{}, light_contours(values, channels, contours)};
  if (field.levels.empty()) return field;
  for (std::size_t k = 0; k < values.size(); k += channels)
    field.cells.push_back(shown_mean(values.subspan(k, channels)));
  return field;
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
  const ToneCurve tone(picture.tone, picture.exposure, light.values, light.channels);
  const Raster cells = cells_raster(light.grid, cell_size(light.grid, picture.wanted_width), [&](std::size_t cell) {
    const auto value = std::span(light.values).subspan(cell * light.channels, light.channels);
    return pixel_of(std::isnan(value[0]) ? palette::kUnlitSolid : tone(value));
  });
  return sheet_file(light.grid, picture, cells, level_field(light.values, light.channels, picture.contours), nullptr);
}

std::string grid_picture_3(const Grid3& grid, const ShownValues& shown, const GridPicture3& picture) {
  HOTTEL_REQUIRE(shown.elements.size() == std::size_t{grid.nu} * grid.nv);
  const Raster cells = cells_raster(grid, cell_size(grid, picture.wanted_width), [&](std::size_t cell) {
    const std::optional<double>& value = shown.elements[cell];
    return pixel_of(value ? scale_colour(shown.scale, *value) : palette::kUnlitSolid);
  });
  return sheet_file(grid, picture, cells, level_field(shown.numbers(), 1, picture.contours), &shown);
}

std::shared_ptr<const LightPainter3> grid_painter_3(const GridPicture3& picture) {
  return std::make_shared<GridPainter3>(picture);
}

}  // namespace hottel

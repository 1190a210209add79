#include "viewer/picture/plane/illumination_painter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "kernel/support/failure.h"
#include "kernel/support/interrupt.h"
#include "kernel/support/parallel.h"
#include "viewer/picture/cairo_canvas.h"
#include "viewer/picture/palette.h"
#include "viewer/picture/plane/axes.h"
#include "viewer/picture/plane/contour_set.h"
#include "viewer/picture/plane/smoothed_field.h"
#include "viewer/picture/plane/solid_polygons.h"
#include "viewer/picture/scale_bar.h"

namespace hottel {
namespace {

constexpr double kBeyondLevels = 16;  // how far values may lie beyond levels, as to contours
constexpr double kCellsBlended = 1;   // the deviation by which light is blended for contours
constexpr double kLeastContour = 14;  // units across

struct PixelsPerCell {
  std::uint32_t across, up;
};

// Whole pixels, so many that the longer side, or the width, has about the wanted length and cells keep their shape.
PixelsPerCell pixels_per_cell(const Grid2& grid, const IlluminationPicture2& picture) {
  if (grid.nx > kMaxPictureSide || grid.ny > kMaxPictureSide)
    throw UsageError("picture: a grid with more than " + std::to_string(kMaxPictureSide) +
                     " cells along a side has no picture");
  const Rational wide = grid.max.x - grid.min.x, high = grid.max.y - grid.min.y;
  const Rational extent = picture.wanted_width > 0 ? wide : std::max(wide, high);
  const std::uint32_t wanted_pixels = picture.wanted_width > 0 ? picture.wanted_width : picture.wanted_side;
  const auto pixels = [&](const Rational& length, std::uint32_t cells) {
    const double wanted = std::round(to_double(length / extent) * wanted_pixels / cells);
    return static_cast<std::uint32_t>(std::clamp(wanted, 1.0, std::floor(double{kMaxPictureSide} / cells)));
  };
  return {pixels(wide, grid.nx), pixels(high, grid.ny)};
}

// Letters stay readable in small pictures.
double letters(double unit) { return std::max(unit, 0.6); }

// What is shown in lines of equal light: of two bands the solar one.
double shown_mean(std::span<const double> value) {
  if (value.size() == 2) return value[0];
  double sum = 0;
  for (const double v : value) sum += v;
  return sum / static_cast<double>(value.size());
}

Frame2 frame_around(const Grid2& grid, const LightPixels2& pixels, bool has_axes, double unit) {
  const double wide = pixels.width(), high = pixels.height();
  if (!has_axes) return {grid.min, grid.max, wide, high};
  const auto whole = [unit](double units) { return std::ceil(units * unit); };  // light keeps to whole pixels
  const SheetMargins2 margins{whole(kAxesMargins2.left), whole(kAxesMargins2.right), whole(kAxesMargins2.top),
                              whole(kAxesMargins2.bottom)};
  return {grid.min, grid.max, wide + margins.left + margins.right, high + margins.top + margins.bottom, margins};
}

// Cuts the squares that come near an edge: light differs on its two sides.
void cut_along(Pixel a, Pixel b, Pixel origin, PixelField2& field) {
  if (field.width < 2 || field.height < 2) return;
  if (field.cut.empty()) field.cut.assign(std::size_t{field.width - 1} * (field.height - 1), false);
  // In squares: the centre of pixel (0, 0) is the corner of square (0, 0).
  for (Pixel* p : {&a, &b}) *p = {p->x - origin.x - 0.5, p->y - origin.y - 0.5};
  if (a.y > b.y) std::swap(a, b);
  const double last_x = field.width - 2, last_y = field.height - 2;
  const double low = std::max(std::floor(a.y - 0.5), 0.0), high = std::min(std::floor(b.y + 0.5), last_y);
  for (double y = low; y <= high; ++y) {
    // Where the edge is within half a square of this row of squares.
    const auto x_at = [&](double at) { return std::lerp(a.x, b.x, std::clamp((at - a.y) / (b.y - a.y), 0.0, 1.0)); };
    const double p = b.y > a.y ? x_at(y - 0.5) : a.x, q = b.y > a.y ? x_at(y + 1.5) : b.x;
    const double left = std::max(std::floor(std::min(p, q) - 0.5), 0.0);
    const double right = std::min(std::floor(std::max(p, q) + 0.5), last_x);
    for (double x = left; x <= right; ++x)
      field.cut[static_cast<std::size_t>(y) * (field.width - 1) + static_cast<std::size_t>(x)] = true;
  }
}

LightPixels2 light_pixels(const PreparedScene2& prepared, const IlluminationGrid2& grid,
                          const IlluminationPicture2& picture) {
  const PixelsPerCell pixels = pixels_per_cell(grid.grid, picture);
  return {prepared, grid, pixels.across, pixels.up};
}

}  // namespace

LitPlan2::LitPlan2(const PreparedScene2& prepared, const Frame2& frame, double unit)
    : scene_(prepared.scene),
      corners_(prepared.scene, frame),
      runs_(prepared, frame),
      solids_(solid_polygons(prepared.arrangement, frame)),
      unit_(unit),
      wall_width_(std::max(2.2 * unit_, 1.0)) {}

void LitPlan2::draw(PictureCanvas& canvas, const ToneCurve& tone) const {
  for (const std::vector<Pixel>& solid : solids_) {
    canvas.fill(Mark::kSolid, solid, palette::kUnlitSolid);
    draw_hatch_2(canvas, solid, 12 * unit_, 0.8 * unit_, palette::kUnlitHatch);
  }
  for (std::uint32_t s = 0; s < corners_.surfaces(); ++s)
    canvas.stroke(Mark::kEdge, corners_.at[corners_.from[s]], corners_.at[corners_.to[s]], palette::kInk, wall_width_);
  draw_emitters(canvas, tone);
}

void LitPlan2::draw_emitters(PictureCanvas& canvas, const ToneCurve& tone) const {
  const Corners2& ends = runs_.corners();
  for (std::uint32_t run = 0; run < ends.surfaces(); ++run) {
    const Surface& surface = scene_.surfaces[runs_.face(run).surface];
    const std::optional<std::uint32_t> own = surface.material_of(runs_.face(run).is_back);
    if (!own || scene_.materials[*own].emission.is_zero()) continue;
    std::array<double, 3> emission{};
    for (const std::uint32_t material : {surface.material, surface.back.value_or(surface.material)})
      for (std::size_t c = 0; c < 3; ++c)
        emission[c] = std::max(emission[c], to_double(scene_.materials[material].emission.value[c]));
    if (scene_.has_bands) emission = {emission[0], emission[0], emission[0]};
    canvas.stroke(Mark::kEmitter, ends.at[ends.from[run]], ends.at[ends.to[run]], tone(emission), 1.3 * wall_width_);
  }
}

Raster toned_pixels_2(const IlluminationGrid2& grid, const LightPixels2& pixels, const ToneCurve& tone) {
  Raster raster(pixels.width(), pixels.height());
  const std::uint32_t up = raster.height / grid.grid.ny, channels = grid.channels;
  const std::uint32_t unlit = pixel_of(palette::kUnlitSolid);
  parallel_for(grid.grid.ny, [&](std::size_t iy) {
    throw_if_interrupted();
    const std::vector<double> row = pixels.row_of_cells(static_cast<std::uint32_t>(iy));
    for (std::uint32_t j = 0; j < up; ++j) {
      std::uint32_t* pixel = raster.pixels.data() + std::size_t{raster.height - 1 - (iy * up + j)} * raster.width;
      for (std::uint32_t x = 0; x < raster.width; ++x) {
        const auto value = std::span(row).subspan((std::size_t{j} * raster.width + x) * channels, channels);
        const std::array<std::uint8_t, 3> level = tone.levels(value);
        pixel[x] = std::isnan(value[0]) ? unlit : pixel_of_levels(level);
      }
    }
  });
  return raster;
}

std::vector<double> light_contours_2(const IlluminationGrid2& grid, int contours) {
  if (contours <= 0) return {};
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (std::size_t k = 0; k < grid.values.size(); k += grid.channels) {
    const double value = shown_mean(std::span(grid.values).subspan(k, grid.channels));
    if (!(value > 0) || std::isinf(value)) continue;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  return most > 0 ? contour_levels_2(least, most, contours) : std::vector<double>();
}

IlluminationPainter2::IlluminationPainter2(const PreparedScene2& prepared, const IlluminationGrid2& grid,
                                           const IlluminationPicture2& picture)
    : grid_(grid),
      contours_(light_contours_2(grid, picture.contours)),
      has_axes_(picture.has_axes),
      length_unit_(length_unit(prepared.scene)),
      pixels_(light_pixels(prepared, grid, picture)),
      unit_(std::max(pixels_.width(), pixels_.height()) / 1600.0),
      frame_(frame_around(grid.grid, pixels_, picture.has_axes, letters(unit_))),
      tone_(picture.curve ? *picture.curve : ToneCurve(picture.tone, picture.exposure, grid.values, grid.channels)),
      plan_(prepared, frame_, unit_) {}

void IlluminationPainter2::draw(PictureCanvas& canvas) const {
  canvas.image(Mark::kLight, frame_.top_left(), frame_.bottom_right(), toned_pixels_2(grid_, pixels_, tone_), false);
  if (!contours_.empty()) draw_contours(canvas);
  plan_.draw(canvas, tone_);
  if (has_axes_) draw_margins(canvas);
}

// The pixels before they are toned, the top row first, cut where edges run.
PixelField2 IlluminationPainter2::field() const {
  PixelField2 field{pixels_.width(), pixels_.height(), {}, {}};
  field.values.resize(std::size_t{field.width} * field.height);
  const std::uint32_t up = field.height / grid_.grid.ny;
  parallel_for(grid_.grid.ny, [&](std::size_t iy) {
    throw_if_interrupted();
    const std::vector<double> row = pixels_.row_of_cells(static_cast<std::uint32_t>(iy));
    for (std::uint32_t j = 0; j < up; ++j) {
      const std::size_t y = field.height - 1 - (iy * up + j);
      for (std::uint32_t x = 0; x < field.width; ++x) {
        const std::size_t k = (std::size_t{j} * field.width + x) * grid_.channels;
        field.values[y * field.width + x] = static_cast<float>(shown_mean(std::span(row).subspan(k, grid_.channels)));
      }
    }
  });
  const Corners2& edges = plan_.edges();
  for (std::uint32_t s = 0; s < edges.surfaces(); ++s)
    cut_along(edges.at[edges.from[s]], edges.at[edges.to[s]], frame_.top_left(), field);
  return field;
}

// By logarithms: light spans decades, and one lamp does not lift what is around it.
void IlluminationPainter2::draw_contours(PictureCanvas& canvas) const {
  const double low = contours_.front() / kBeyondLevels, high = contours_.back() * kBeyondLevels;
  PixelField2 logs = field();
  for (float& value : logs.values) value = static_cast<float>(std::log(std::clamp<double>(value, low, high)));
  logs = smoothed_2(std::move(logs), kCellsBlended * logs.width / grid_.grid.nx);
  std::vector<double> levels;
  for (const double level : contours_) levels.push_back(std::log(level));
  const double size = letters(unit_);
  const std::vector<Contour2> contours = contour_set_2(logs, levels, kLeastContour * size);
  std::vector<std::string> names;
  for (const Contour2& contour : contours) names.push_back(fmt::format("{:.6g}", std::exp(contour.level)));
  draw_contours_2(canvas, contours, names, logs, frame_.top_left(), size);
}

// Paper around the light, over what the plan draws there.
void IlluminationPainter2::draw_margins(PictureCanvas& canvas) const {
  const Pixel from = frame_.top_left(), to = frame_.bottom_right();
  const double wide = frame_.width(), high = frame_.height(), size = letters(unit_);
  canvas.fill_rectangle(Mark::kPaper, {0, 0}, {wide, from.y}, palette::kPaper);
  canvas.fill_rectangle(Mark::kPaper, {0, to.y}, {wide, high}, palette::kPaper);
  canvas.fill_rectangle(Mark::kPaper, {0, from.y}, {from.x, to.y}, palette::kPaper);
  canvas.fill_rectangle(Mark::kPaper, {to.x, from.y}, {wide, to.y}, palette::kPaper);
  draw_axes_2(canvas, frame_, size, length_unit_);
  const double room = std::min(190 * size, (to.x - from.x) / 4);
  draw_scale_bar(canvas, frame_.pixels_per_length(), length_unit_,
                 {.right = {to.x, to.y + 34 * size}, .room = room, .unit = size});
}

LightPicture2 illumination_picture_2(const PreparedScene2& prepared, const IlluminationGrid2& grid,
                                     const IlluminationPicture2& picture, PictureFormat format) {
  const IlluminationPainter2 painter(prepared, grid, picture);
  CairoCanvas canvas(format, painter.width(), painter.height());
  painter.draw(canvas);
  return {.bytes = canvas.finish(), .scale = painter.tone().scale()};
}

std::shared_ptr<const LightPainter2> light_painter_2(const IlluminationPicture2& picture, PictureFormat format) {
  class Painter final : public LightPainter2 {
   public:
    Painter(const IlluminationPicture2& what, PictureFormat as) : picture_(what), format_(as) {}
    LightPicture2 paint(const PreparedScene2& prepared, const IlluminationGrid2& light) const override {
      return illumination_picture_2(prepared, light, picture_, format_);
    }

   private:
    IlluminationPicture2 picture_;
    PictureFormat format_;
  };
  return std::make_shared<const Painter>(picture, format);
}

}  // namespace hottel

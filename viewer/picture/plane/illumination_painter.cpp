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
#include "viewer/picture/light_contours.h"
#include "viewer/picture/palette.h"
#include "viewer/picture/plane/axes.h"
#include "viewer/picture/plane/solid_polygons.h"
#include "viewer/picture/scale_bar.h"

namespace hottel {
namespace {

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

Frame2 frame_around(const Grid2& grid, const LightPixels2& pixels, bool has_axes, double unit) {
  const double wide = pixels.width(), high = pixels.height();
  if (!has_axes) return {grid.min, grid.max, wide, high};
  const auto whole = [unit](double units) { return std::ceil(units * unit); };  // light keeps to whole pixels
  const SheetMargins2 margins{whole(kAxesMargins2.left), whole(kAxesMargins2.right), whole(kAxesMargins2.top),
                              whole(kAxesMargins2.bottom)};
  return {grid.min, grid.max, wide + margins.left + margins.right, high + margins.top + margins.bottom, margins};
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
  return light_contours(grid.values, grid.channels, contours);
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
  if (!contours_.empty())
    draw_light_contours(canvas, field(), contours_, pixels_.width() / static_cast<double>(grid_.grid.nx),
                        frame_.top_left(), letters(unit_));
  plan_.draw(canvas, tone_);
  if (has_axes_) draw_margins(canvas);
}

// The pixels before they are toned, the top row first, cut where edges run.
PixelField IlluminationPainter2::field() const {
  PixelField field{pixels_.width(), pixels_.height(), {}, {}};
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

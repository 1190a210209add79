#include "viewer/picture/plane/illumination_painter.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "kernel/support/failure.h"
#include "kernel/support/interrupt.h"
#include "kernel/support/parallel.h"
#include "viewer/picture/cairo_canvas.h"
#include "viewer/picture/palette.h"
#include "viewer/picture/plane/solid_polygons.h"

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
        pixel[x] = std::isnan(value[0]) ? unlit : 0xFF000000u | level[0] << 16 | level[1] << 8 | level[2];
      }
    }
  });
  return raster;
}

IlluminationPainter2::IlluminationPainter2(const PreparedScene2& prepared, const IlluminationGrid2& grid,
                                           const IlluminationPicture2& picture)
    : grid_(grid),
      pixels_(light_pixels(prepared, grid, picture)),
      tone_(picture.curve ? *picture.curve : ToneCurve(picture.tone, picture.exposure, grid.values, grid.channels)),
      plan_(prepared, Frame2(grid.grid.min, grid.grid.max, pixels_.width(), pixels_.height()),
            std::max(pixels_.width(), pixels_.height()) / 1600.0) {}

void IlluminationPainter2::draw(PictureCanvas& canvas) const {
  canvas.image(Mark::kLight, {0, 0}, {canvas.width(), canvas.height()}, toned_pixels_2(grid_, pixels_, tone_), false);
  plan_.draw(canvas, tone_);
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

#include "viewer/picture/plane/illumination_painter.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "kernel/support/failure.h"
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

LightPixels2 light_pixels(const Scene2& scene, const IlluminationGrid2& grid, const IlluminationPicture2& picture) {
  const PixelsPerCell pixels = pixels_per_cell(grid.grid, picture);
  return {grid, pixels.across, pixels.up, &scene};
}

}  // namespace

IlluminationPainter2::IlluminationPainter2(const PreparedScene2& prepared, const IlluminationGrid2& grid,
                                           const IlluminationPicture2& picture)
    : scene_(prepared.scene),
      grid_(grid),
      pixels_(light_pixels(prepared.scene, grid, picture)),
      tone_(picture.tone, picture.exposure, grid.values, grid.channels),
      frame_(grid.grid.min, grid.grid.max, pixels_.width(), pixels_.height()),
      corners_(prepared.scene, frame_),
      runs_(prepared, frame_),
      solids_(solid_polygons(prepared.arrangement, frame_)),
      unit_(std::max(pixels_.width(), pixels_.height()) / 1600.0),
      wall_width_(std::max(2.2 * unit_, 1.0)) {}

PixelImage IlluminationPainter2::light() const {
  PixelImage image{width(), height(), {}};
  image.pixels.resize(std::size_t{image.width} * image.height);
  const std::uint32_t up = image.height / grid_.grid.ny, channels = grid_.channels;
  parallel_for(grid_.grid.ny, [&](std::size_t iy) {
    const std::vector<double> row = pixels_.row_of_cells(static_cast<std::uint32_t>(iy));
    for (std::uint32_t j = 0; j < up; ++j)
      for (std::uint32_t x = 0; x < image.width; ++x) {
        const auto value = std::span(row).subspan((std::size_t{j} * image.width + x) * channels, channels);
        Colour& pixel = image.pixels[std::size_t{image.height - 1 - (iy * up + j)} * image.width + x];
        if (std::isnan(value[0])) {
          pixel = palette::kUnlitSolid;
          continue;
        }
        const auto [r, g, b] = tone_.levels(value);
        pixel = {r / 255.0, g / 255.0, b / 255.0};
      }
  });
  return image;
}

void IlluminationPainter2::draw(PictureCanvas& canvas) const {
  canvas.image(Mark::kLight, {0, 0}, {frame_.width(), frame_.height()}, light(), false);
  for (const std::vector<Pixel>& solid : solids_) {
    canvas.fill(Mark::kSolid, solid, palette::kUnlitSolid);
    draw_hatch_2(canvas, solid, 12 * unit_, 0.8 * unit_, palette::kUnlitHatch);
  }
  draw_walls(canvas);
}

void IlluminationPainter2::draw_walls(PictureCanvas& canvas) const {
  const auto stroke = [&](const Corners2& corners, std::uint32_t k, Mark mark, const Colour& colour,
                          double line_width) {
    canvas.stroke(mark, corners.at[corners.from[k]], corners.at[corners.to[k]], colour, line_width);
  };
  for (std::uint32_t s = 0; s < corners_.surfaces(); ++s) stroke(corners_, s, Mark::kEdge, palette::kInk, wall_width_);
  for (std::uint32_t run = 0; run < runs_.corners().surfaces(); ++run) {
    const Surface& surface = scene_.surfaces[runs_.face(run).surface];
    const std::optional<std::uint32_t> own = runs_.face(run).is_back ? surface.back : surface.material;
    if (!own || scene_.materials[*own].emission.is_zero()) continue;
    std::array<double, 3> emission{};
    for (const std::uint32_t material : {surface.material, surface.back.value_or(surface.material)})
      for (std::size_t c = 0; c < 3; ++c)
        emission[c] = std::max(emission[c], to_double(scene_.materials[material].emission.value[c]));
    stroke(runs_.corners(), run, Mark::kEmitter, tone_(emission), 1.3 * wall_width_);
  }
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

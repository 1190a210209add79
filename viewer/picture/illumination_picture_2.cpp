#include "viewer/picture/illumination_picture_2.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernel/failure.h"
#include "kernel/parallel.h"
#include "viewer/picture/hatch.h"
#include "viewer/picture/palette.h"

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

// The part of an image, drawn where it lies, that covers a box.
void draw_part(PictureCanvas& canvas, const PixelImage& image, Pixel top_left, Pixel bottom_right) {
  const auto whole = [](double place, std::uint32_t limit) {
    return static_cast<std::uint32_t>(std::clamp(place, 0.0, static_cast<double>(limit)));
  };
  const std::uint32_t left = whole(std::floor(top_left.x), image.width),
                      right = whole(std::ceil(bottom_right.x), image.width),
                      top = whole(std::floor(top_left.y), image.height),
                      bottom = whole(std::ceil(bottom_right.y), image.height);
  if (left >= right || top >= bottom) return;
  PixelImage part{right - left, bottom - top, {}};
  for (std::uint32_t y = top; y < bottom; ++y) {
    const auto row = image.pixels.begin() + static_cast<std::ptrdiff_t>(std::size_t{y} * image.width);
    part.pixels.insert(part.pixels.end(), row + left, row + right);
  }
  canvas.image(Mark::kLight, {double(left), double(top)}, {double(right), double(bottom)}, part, false);
}

LightPixels2 light_pixels(const Scene2& scene, const IlluminationGrid& grid, const IlluminationPicture2& picture) {
  const PixelsPerCell pixels = pixels_per_cell(grid.grid, picture);
  return {grid, pixels.across, pixels.up, &scene};
}

}  // namespace

IlluminationPainter2::IlluminationPainter2(const Scene2& scene, const IlluminationGrid& grid,
                                           const IlluminationPicture2& picture)
    : scene_(scene),
      grid_(grid),
      pixels_(light_pixels(scene, grid, picture)),
      tone_(picture.tone, picture.exposure, grid.values, grid.channels),
      frame_(grid.grid.min, grid.grid.max, pixels_.width(), pixels_.height()),
      corners_(scene, frame_),
      outlines_(scene, corners_),
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
        const auto [r, g, b] =
            tone_.levels(std::span(row).subspan((std::size_t{j} * image.width + x) * channels, channels));
        image.pixels[std::size_t{image.height - 1 - (iy * up + j)} * image.width + x] = {r / 255.0, g / 255.0,
                                                                                         b / 255.0};
      }
  });
  return image;
}

void IlluminationPainter2::draw(PictureCanvas& canvas) const {
  const PixelImage image = light();
  canvas.image(Mark::kLight, {0, 0}, {frame_.width(), frame_.height()}, image, false);
  std::vector<const Outline2*> by_level;
  for (const Outline2& outline : outlines_.closed) by_level.push_back(&outline);
  std::stable_sort(by_level.begin(), by_level.end(),
                   [](const Outline2* a, const Outline2* b) { return a->level < b->level; });
  for (const Outline2* outline : by_level) {
    const bool is_drawn_around = outline->around && outlines_.closed[*outline->around].solid == outline->solid;
    if (is_drawn_around) continue;
    if (outline->solid) {
      canvas.fill(Mark::kSolid, outline->polygon, palette::kUnlitSolid);
      draw_hatch(canvas, outline->polygon, 12 * unit_, 0.8 * unit_, palette::kUnlitHatch);
    } else if (outline->around) {
      canvas.clip(outline->polygon);
      draw_part(canvas, image, outline->top_left, outline->bottom_right);
      canvas.unclip();
    }
  }
  draw_walls(canvas);
}

void IlluminationPainter2::draw_walls(PictureCanvas& canvas) const {
  const auto stroke = [&](std::uint32_t s, Mark mark, const Colour& colour, double line_width) {
    canvas.stroke(mark, corners_.at[corners_.from[s]], corners_.at[corners_.to[s]], colour, line_width);
  };
  for (std::uint32_t s = 0; s < corners_.surfaces(); ++s) stroke(s, Mark::kEdge, palette::kInk, wall_width_);
  for (std::uint32_t s = 0; s < corners_.surfaces(); ++s) {
    const Surface2& surface = scene_.surfaces[s];
    std::array<double, 3> emission{};
    for (const std::uint32_t material : {surface.material, surface.back.value_or(surface.material)})
      for (std::size_t c = 0; c < 3; ++c)
        emission[c] = std::max(emission[c], to_double(scene_.materials[material].emission.value[c]));
    if (*std::max_element(emission.begin(), emission.end()) > 0)
      stroke(s, Mark::kEmitter, tone_(emission), 1.3 * wall_width_);
  }
}

std::string illumination_picture_2(const Scene2& scene, const IlluminationGrid& grid,
                                   const IlluminationPicture2& picture, PictureFormat format) {
  const IlluminationPainter2 painter(scene, grid, picture);
  CairoCanvas canvas(format, painter.width(), painter.height());
  painter.draw(canvas);
  return canvas.finish();
}

}  // namespace hottel

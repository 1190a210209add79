#include "viewer/picture/plane/shown_picture.h"

#include <limits>

#include "kernel/rational.h"
#include "kernel/support/failure.h"
#include "viewer/picture/colour_map.h"
#include "viewer/picture/light_contours.h"
#include "viewer/picture/plane/scene_painter.h"

namespace hottel {

ScenePicture2 shown_plan_2(const ShownValues& values, const ShownPlan2& plan) {
  ScenePicture2 picture;
  picture.sheet.has_axes = plan.has_axes;
  if (plan.width > 0) picture.sheet.width = plan.width;
  picture.colouring = FaceColouring2{
      .elements = values.elements, .shading = plan.shading, .scale = values.scale, .title = values.title};
  return picture;
}

namespace {

// Each cell a pixel, rows from the largest y down; transparent where there is no value.
std::shared_ptr<const ScenePixels2> pixels_of(const ShownCells2& cells, int contours) {
  const Grid2& grid = cells.grid;
  HOTTEL_REQUIRE(cells.values.elements.size() == std::size_t{grid.nx} * grid.ny);
  auto pixels = std::make_shared<ScenePixels2>();
  pixels->min = {to_double(grid.min.x), to_double(grid.min.y)};
  pixels->max = {to_double(grid.max.x), to_double(grid.max.y)};
  pixels->smooth = false;
  pixels->image = Raster(grid.nx, grid.ny);
  for (std::uint32_t y = 0; y < grid.ny; ++y)
    for (std::uint32_t x = 0; x < grid.nx; ++x) {
      const std::optional<double>& value = cells.values.elements[std::size_t{grid.ny - 1 - y} * grid.nx + x];
      const Colour colour = value ? scale_colour(cells.values.scale, *value) : Colour{0, 0, 0, 0};
      pixels->image.pixels[std::size_t{y} * grid.nx + x] = pixel_of(colour);
      pixels->values.push_back(value.value_or(std::numeric_limits<double>::quiet_NaN()));
    }
  pixels->levels = light_contours(pixels->values, 1, contours);
  return pixels;
}

}  // namespace

std::string shown_picture_2(const PreparedScene2& prepared, const ShownValues& values, const ShownPlan2& plan,
                            PictureFormat format, const ShownCells2* cells) {
  ScenePicture2 picture = shown_plan_2(values, plan);
  if (cells != nullptr) picture.pixels = pixels_of(*cells, plan.contours);
  return scene_picture_2(prepared, picture, format);
}

}  // namespace hottel

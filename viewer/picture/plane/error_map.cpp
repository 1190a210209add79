#include "viewer/picture/plane/error_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "solver/plane/light/illumination_grid.h"
#include "viewer/picture/colour_map.h"
#include "viewer/picture/plane/scene_painter.h"

namespace hottel {
namespace {

constexpr double kDecades = 1e-4;  // least over largest value of the scale
constexpr std::uint32_t kCells = 256;

// Calls set(element, error) for each element with a row.
template <class Set>
void for_each_element_error(const RadiositySolution& found, const RadiositySolution& exact, double scale,
                            const Set& set) {
  for (std::size_t c = 0; c < exact.channels.size(); ++c)
    for (std::size_t i = 0; i < exact.channels[c].elements.size(); ++i)
      set(i, std::abs(found.channels[c].elements[i].radiosity - exact.channels[c].elements[i].radiosity) / scale);
}

FaceColouring2 face_errors(const MethodComparison2& comparison, const MethodResult& result, double scale) {
  FaceColouring2 colouring;
  colouring.front.resize(comparison.prepared().scene.surfaces.size());
  colouring.back.resize(colouring.front.size());
  for_each_element_error(*result.solution, *comparison.exact_solution(), scale, [&](std::size_t i, double error) {
    const Element& element = comparison.exact().elements()[i];
    if (!comparison.exact().has_row(static_cast<std::uint32_t>(i))) return;
    std::optional<double>& value = (element.is_back ? colouring.back : colouring.front)[element.surface];
    value = std::max(value.value_or(0), error);
  });
  return colouring;
}

// The light of both solutions, in one look.
std::vector<IlluminationGrid2> light_of(const MethodComparison2& comparison, const RadiositySolution& found,
                                        const RadiositySolution& exact) {
  const PreparedScene2& prepared = comparison.prepared();
  const ElementTable2& table = *prepared.elements(Granularity::kElement);
  const SentOut2 both[] = {sent_out_2(table, found, prepared.scene), sent_out_2(table, exact, prepared.scene)};
  return illuminate_points(prepared, default_grid(prepared.scene, kCells), table, both);
}

// By cell, C order (ny, nx).
std::vector<double> cell_errors(const IlluminationGrid2& found, const IlluminationGrid2& exact, double scale) {
  std::vector<double> errors(exact.values.size() / exact.channels, 0);
  for (std::size_t k = 0; k < exact.values.size(); ++k) {
    double& error = errors[k / exact.channels];
    error = std::max(error, std::abs(found.values[k] - exact.values[k]) / scale);  // 0 in solids, where both are NaN
  }
  return errors;
}

ScenePixels2 pixels_of(const Grid2& grid, const std::vector<double>& errors, const ColourScale& scale) {
  ScenePixels2 pixels;
  pixels.image = Raster(grid.nx, grid.ny);
  auto pixel = pixels.image.pixels.begin();
  for (std::uint32_t row = grid.ny; row-- > 0;)
    for (std::uint32_t x = 0; x < grid.nx; ++x)
      *pixel++ = pixel_of(scale_colour(scale, errors[std::size_t{row} * grid.nx + x]));
  pixels.min = to_doubles(grid.min);
  pixels.max = to_doubles(grid.max);
  return pixels;
}

}  // namespace

ScenePicture2 error_map_picture_2(const MethodComparison2& comparison, const MethodResult& result) {
  ScenePicture2 picture;
  picture.sheet.title = "Error of the light: " + result.info.name;
  const double scale = comparison.exact_solution() ? largest_radiosity(*comparison.exact_solution()) : 0;
  if (!result.solution || scale == 0) {
    picture.sheet.subtitle = "no radiosities to compare";
    return picture;
  }
  FaceColouring2 colouring = face_errors(comparison, result, scale);
  const std::vector<IlluminationGrid2> light = light_of(comparison, *result.solution, *comparison.exact_solution());
  const std::vector<double> errors = cell_errors(light[0], light[1], scale);
  double largest = *std::max_element(errors.begin(), errors.end());
  bool has_zero = false;
  for (std::size_t k = 0; k < errors.size(); ++k)
    has_zero = has_zero || (errors[k] == 0 && !std::isnan(light[1].values[k * light[1].channels]));
  for (const auto* faces : {&colouring.front, &colouring.back})
    for (const std::optional<double>& face : *faces) {
      largest = std::max(largest, face.value_or(0));
      has_zero = has_zero || face == 0.0;
    }
  colouring.scale = largest > 0 ? ColourScale{kDecades * largest, largest, true} : ColourScale{0, 1, false};
  colouring.scale.has_zero = colouring.scale.logarithmic && has_zero;
  colouring.title = "|error| / largest radiosity: of radiosity on faces, of mean irradiance on floors";
  picture.sheet.subtitle =
      fmt::format("radiosities wrong by at most {:.2g} of the largest", *result.max_radiosity_error);
  picture.pixels = std::make_shared<ScenePixels2>(pixels_of(light[1].grid, errors, colouring.scale));
  picture.colouring = std::move(colouring);
  return picture;
}

std::string error_map_2(const MethodComparison2& comparison, const MethodResult& result, PictureFormat format) {
  return scene_picture_2(comparison.prepared(), error_map_picture_2(comparison, result), format);
}

}  // namespace hottel

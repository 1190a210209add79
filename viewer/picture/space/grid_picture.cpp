#include "viewer/picture/space/grid_picture.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "viewer/picture/palette.h"
#include "viewer/picture/png_file.h"
#include "viewer/picture/raster.h"
#include "viewer/picture/tone_curve.h"

namespace hottel {
namespace {

constexpr double kLongerSide = 800;

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

class GridPainter3 final : public LightPainter3 {
 public:
  explicit GridPainter3(const GridPicture3& picture) : picture_(picture) {}
  LightPicture3 paint(const IlluminationGrid3& light) const override { return {grid_picture_3(light, picture_)}; }

 private:
  GridPicture3 picture_;
};

}  // namespace

std::string grid_picture_3(const IlluminationGrid3& light, const GridPicture3& picture) {
  const Rational unit = largest_component(light.grid.u, light.grid.v);
  const double u = length(light.grid.u, unit), v = length(light.grid.v, unit);  // one of them at least 1
  const double width = picture.wanted_width > 0 ? picture.wanted_width : kLongerSide * (u / std::max(u, v));
  const double height = picture.wanted_width > 0 ? width * (v / u) : kLongerSide * (v / std::max(u, v));
  const std::uint32_t across = pixels_a_cell(width, light.grid.nu), up = pixels_a_cell(height, light.grid.nv);
  const ToneCurve tone(picture.tone, picture.exposure, light.values, light.channels);
  Raster raster(across * light.grid.nu, up * light.grid.nv);
  for (std::uint32_t y = 0; y < raster.height; ++y)
    for (std::uint32_t x = 0; x < raster.width; ++x) {
      const std::size_t cell = std::size_t{(raster.height - 1 - y) / up} * light.grid.nu + x / across;
      const auto value = std::span(light.values).subspan(cell * light.channels, light.channels);
      raster.pixels[std::size_t{y} * raster.width + x] =
          pixel_of(std::isnan(value[0]) ? palette::kUnlitSolid : tone(value));
    }
  return png_file(raster);
}

std::shared_ptr<const LightPainter3> grid_painter_3(const GridPicture3& picture) {
  return std::make_shared<GridPainter3>(picture);
}

}  // namespace hottel

#include "viewer/picture/space/render_picture.h"

#include <algorithm>
#include <cmath>

#include "geometry/space/exchange/prepared_scene.h"
#include "viewer/picture/png_file.h"
#include "viewer/picture/raster.h"
#include "viewer/picture/tone_curve.h"

namespace hottel {

RenderedPicture3 render_picture_3(const PreparedScene3& prepared, Granularity granularity,
                                  const RadiositySolution& solution, const RenderOptions3& options) {
  Camera3 camera = prepared.scene.camera ? *prepared.scene.camera : default_camera_3(prepared);
  if (options.wanted_width > 0) {
    const double height = std::round(static_cast<double>(camera.height) * options.wanted_width / camera.width);
    camera.width = options.wanted_width;
    camera.height = static_cast<std::uint32_t>(std::clamp(height, 1.0, static_cast<double>(kMaxPictureSide)));
  }
  const PixelValues3 pixels = camera_view_3(prepared, granularity, solution, camera);
  const ToneCurve tone(options.tone, options.exposure, pixels.values, pixels.channels);
  Raster raster(camera.width, camera.height);
  for (std::uint32_t y = 0; y < camera.height; ++y)
    for (std::uint32_t x = 0; x < camera.width; ++x) {
      const auto level = tone.levels(pixels.at(x, y));
      raster.pixels[std::size_t{y} * camera.width + x] = 0xFF000000u | level[0] << 16 | level[1] << 8 | level[2];
    }
  return {png_file(raster), tone.scale()};
}

}  // namespace hottel

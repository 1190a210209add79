// The light that a camera sees, as a picture.
#pragma once

#include <cstdint>
#include <string>

#include "viewer/picture/picture_options.h"
#include "viewer/picture/space/camera_view.h"

namespace hottel {

// How light becomes a picture.
struct RenderOptions3 {
  Tone tone = Tone::kLog;
  double exposure = 1;             // what the light is multiplied by; ToneCurve says relative to what
  std::uint32_t wanted_width = 0;  // pixels across instead of the camera's, in its shape, where not 0
};

struct RenderedPicture3 {
  std::string bytes;  // of a PNG file
  double scale = 1;   // what values were multiplied by before they were toned
};

// Returns the picture of the scene's camera, or of default_camera_3, each element in its radiosity (camera_view_3).
// Throws as camera_view_3 does.
RenderedPicture3 render_picture_3(const PreparedScene3& prepared, Granularity granularity,
                                  const RadiositySolution& solution, const RenderOptions3& options);

}  // namespace hottel

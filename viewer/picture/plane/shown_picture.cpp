#include "viewer/picture/plane/shown_picture.h"

namespace hottel {

ScenePicture2 shown_plan_2(const ShownValues& values, std::uint32_t width, bool has_axes) {
  ScenePicture2 picture;
  picture.sheet.has_axes = has_axes;
  if (width > 0) picture.sheet.width = width;
  picture.colouring = FaceColouring2{.elements = values.elements, .scale = values.scale, .title = values.title};
  return picture;
}

std::string shown_picture_2(const PreparedScene2& prepared, const ShownValues& values, std::uint32_t width,
                            bool has_axes, PictureFormat format) {
  return scene_picture_2(prepared, shown_plan_2(values, width, has_axes), format);
}

}  // namespace hottel

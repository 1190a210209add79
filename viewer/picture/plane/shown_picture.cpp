#include "viewer/picture/plane/shown_picture.h"

namespace hottel {

ScenePicture2 shown_plan_2(const ShownValues& values, std::uint32_t width) {
  ScenePicture2 picture;
  if (width > 0) picture.sheet.width = width;
  picture.colouring = FaceColouring2{.elements = values.elements, .scale = values.scale, .title = values.title};
  return picture;
}

std::string shown_picture_2(const PreparedScene2& prepared, const ShownValues& values, std::uint32_t width,
                            PictureFormat format) {
  return scene_picture_2(prepared, shown_plan_2(values, width), format);
}

}  // namespace hottel

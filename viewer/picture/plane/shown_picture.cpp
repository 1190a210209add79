#include "viewer/picture/plane/shown_picture.h"

namespace hottel {

ScenePicture2 shown_plan_2(const ShownValues& values, const ShownPlan2& plan) {
  ScenePicture2 picture;
  picture.sheet.has_axes = plan.has_axes;
  if (plan.width > 0) picture.sheet.width = plan.width;
  picture.colouring = FaceColouring2{
      .elements = values.elements, .shading = plan.shading, .scale = values.scale, .title = values.title};
  return picture;
}

std::string shown_picture_2(const PreparedScene2& prepared, const ShownValues& values, const ShownPlan2& plan,
                            PictureFormat format) {
  return scene_picture_2(prepared, shown_plan_2(values, plan), format);
}

}  // namespace hottel

#include "viewer/picture/space/eye_map.h"

#include "kernel/support/failure.h"

namespace hottel {

VisibilityMap3 eye_map_3(const PreparedScene3& prepared, const Camera3& camera) {
  if (const auto mesh = prepared.arrangement().solids().around(camera.eye))
    throw RequestError("the camera's eye is in the solid '" + prepared.arrangement().solids().meshes()[*mesh].name +
                       "'");
  const Vector3 forward = camera.target - camera.eye;
  return map_from(prepared.occluders(), {.eye = camera.eye, .normal = Point3{forward.x, forward.y, forward.z}});
}

}  // namespace hottel

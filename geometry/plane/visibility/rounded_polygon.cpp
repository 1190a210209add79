#include "geometry/plane/visibility/rounded_polygon.h"

#include <algorithm>

namespace hottel {

bool RoundedPolygon2::sees_sky() const {
  return std::any_of(corners.begin(), corners.end(), [](const Corner& corner) { return corner.after == kSky; });
}

}  // namespace hottel

#include "geometry/plane/scene/bounding_box.h"

#include "geometry/plane/scene/scene.h"

namespace hottel {

void Box2::include(const Point2& point) {
  if (point.x < min.x) min.x = point.x;
  if (point.y < min.y) min.y = point.y;
  if (point.x > max.x) max.x = point.x;
  if (point.y > max.y) max.y = point.y;
}

Box2 bounding_box(const Scene2& scene) {
  if (scene.edges.empty()) return {};
  Box2 box = Box2::of(scene.edges.front().from);
  for (const Edge2& edge : scene.edges) {
    box.include(edge.from);
    box.include(edge.to);
  }
  return box;
}

}  // namespace hottel

#include "viewer/picture/space/camera_view.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/visibility/seen_faces.h"
#include "geometry/space/visibility/visibility_map.h"
#include "viewer/picture/space/pixel_painter.h"

namespace hottel {

PixelValues3 camera_view_3(const SeenScene3& scene, const Camera3& camera) {
  PixelPainter3 painter(scene.paint, camera);
  for_each_seen_part(scene, camera, [&](const SeenPart3& part) { painter.add(part); });
  return painter.finished();
}

PixelValues3 camera_view_3(const PreparedScene3& prepared, Granularity granularity, const RadiositySolution& solution,
                           const Camera3& camera) {
  const ElementTable3& table = *prepared.elements(granularity);
  const ElementPaint3 paint = light_paint_3(prepared.scene, solution);
  return camera_view_3({prepared, table, paint}, camera);
}

namespace {

// Where an eye may stand: within what surrounds it, under the sky, or in a solid or behind walls.
enum class Place : unsigned char { kRoom, kOpen, kHidden };

Place place_of(const PreparedScene3& prepared, const Point3& eye) {
  if (prepared.arrangement().solids().around(eye)) return Place::kHidden;
  const VisibilityMap3 map =
      with_owners(map_from(prepared.occluders(), {.eye = eye, .normal = {}}), prepared.arrangement());
  if (map.sky_fraction >= 0.5) return Place::kOpen;
  double lit = 0;
  for (const VisibilityMap3::Share& share : map.shares)
    if (prepared.scene.surfaces[share.face.surface].material_of(share.face.is_back)) lit += share.fraction;
  return lit >= 0.5 ? Place::kRoom : Place::kHidden;
}

}  // namespace

Camera3 default_camera_3(const PreparedScene3& prepared) {
  Camera3 camera;
  if (prepared.scene.polygons.empty()) {
    camera.target = {0, 1, 0};
    return camera;
  }
  Point3 low = prepared.scene.polygons[0].points[0], high = low;
  for (const Polygon3& polygon : prepared.scene.polygons)
    for (const Point3& p : polygon.points)
      for (Rational Point3::*axis : {&Point3::x, &Point3::y, &Point3::z}) {
        low.*axis = std::min(low.*axis, p.*axis);
        high.*axis = std::max(high.*axis, p.*axis);
      }
  const auto between = [&](const Rational& x, const Rational& y, const Rational& z) {
    return Point3{low.x + x * (high.x - low.x), low.y + y * (high.y - low.y), low.z + z * (high.z - low.z)};
  };
  const Rational half(1, 2);
  const Point3 middle = between(half, half, half);
  if (const Place place = place_of(prepared, middle); place != Place::kOpen) {
    camera.field_of_view = 75;
    camera.target = between(half, half, Rational(2, 5));
    using Spot = std::array<Rational, 2>;
    const Rational aside(4, 9), near(1, 9), far(8, 9);
    for (const auto& [x, y] :
         {Spot{aside, Rational(1, 33)}, Spot{aside, near}, Spot{aside, Rational(1, 5)}, Spot{aside, Rational(1, 3)},
          Spot{near, near}, Spot{far, near}, Spot{near, far}, Spot{far, far}}) {
      camera.eye = between(x, y, Rational(3, 5));
      if (place_of(prepared, camera.eye) == Place::kRoom) return camera;
    }
    camera.field_of_view = Camera3().field_of_view;
  }
  Rational size;
  for (const Rational& side : {Rational(high.x - low.x), Rational(high.y - low.y), Rational(high.z - low.z)})
    size = std::max(size, side);
  camera.target = middle;
  camera.eye = {middle.x - size * Rational(4, 5), middle.y - size * Rational(3, 2), middle.z + size * Rational(6, 5)};
  return camera;
}

}  // namespace hottel

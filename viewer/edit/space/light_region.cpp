#include "viewer/edit/space/light_region.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/name.h"
#include "geometry/scene_names.h"
#include "geometry/space/scene/light_place_problem.h"
#include "geometry/space/visibility/direction.h"
#include "kernel/plain_functions.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// The solid angle of a triangle seen from the origin, with a sign. [full spheres]
// SEE: Van Oosterom, Strackee, The solid angle of a plane triangle, 1983.
double signed_angle(const Direction3& a, const Direction3& b, const Direction3& c) {
  const double la = length(a), lb = length(b), lc = length(c);
  const double below = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
  return same_bits::atan2(dot(a, cross(b, c)), below) / (2 * std::numbers::pi);
}

// How often a mesh winds around a point: by fans over the sides of its polygons, each in its sense.
int winding(const Scene3& scene, const ClosedMesh3& mesh, const Point3& point) {
  double sum = 0;
  const auto way = [&point](const Point3& corner) {
    const Vector3 v = corner - point;
    return Direction3{to_double(v.x), to_double(v.y), to_double(v.z)};
  };
  const ClosedMesh3::Face* before = nullptr;
  for (const ClosedMesh3::Face& face : mesh.faces) {
    const bool is_another = before == nullptr || before->surface != face.surface;
    before = &face;
    if (!is_another) continue;
    const Polygon3& polygon = scene.polygons[face.surface];
    const Direction3 apex = way(polygon.points[0]);
    for (const Side3& side : sides_of(polygon)) sum += signed_angle(apex, way(side.from), way(side.to));
  }
  return static_cast<int>(std::lround(sum));
}

// The first room that a point is in.
const ClosedMesh3* room_around(const Scene3& scene, const Solids3& solids, const Point3& point) {
  for (const ClosedMesh3& mesh : solids.meshes())
    if (mesh.kind == ClosedMesh3::Kind::kRoom && winding(scene, mesh, point) != 0) return &mesh;
  return nullptr;
}

}  // namespace

std::string light_refusal(const Scene3& scene, std::uint32_t light, const Solids3& solids, const Point3* before) {
  HOTTEL_REQUIRE(light < scene.lights.size());
  const LightPlace3& place = scene.light_places[light];
  if (const std::string problem = light_place_problem(scene, scene.lights[light], place); !problem.empty())
    return scene.lights[light].name + " " + problem;
  if (scene.lights[light].is_sun()) return "";
  if (const auto mesh = solids.around(place.position))
    return "there is the solid " + quoted_name(solids.meshes()[*mesh].name);
  const ClosedMesh3* room = before != nullptr ? room_around(scene, solids, *before) : nullptr;
  if (room != nullptr && room_around(scene, solids, place.position) == nullptr)
    return "that is outside of the room " + quoted_name(room->name);
  return "";
}

}  // namespace hottel

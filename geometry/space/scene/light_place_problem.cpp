#include "geometry/space/scene/light_place_problem.h"

#include <algorithm>
#include <array>

#include "geometry/light_motion.h"
#include "geometry/name.h"

namespace hottel {
namespace {

// Whether a place is in the box around a polygon.
bool is_near(const Polygon3& polygon, const Point3& place) {
  return std::ranges::all_of(std::array{&Point3::x, &Point3::y, &Point3::z}, [&](Rational Point3::*axis) {
    const auto has = [&](bool above) {
      return std::ranges::any_of(
          polygon.points, [&](const Point3& p) { return above ? p.*axis >= place.*axis : p.*axis <= place.*axis; });
    };
    return has(false) && has(true);
  });
}

}  // namespace

std::string light_place_problem(const Scene3& scene, const Light& light, const LightPlace3& place) {
  if (light.type != LightType::kPoint && place.direction.is_zero()) return "shines nowhere: its direction is zero";
  if (light.is_sun()) return place.path ? "is a sun: it has no path" : "";
  for (std::size_t s = 0; s < scene.polygons.size(); ++s) {
    if (!is_near(scene.polygons[s], place.position)) continue;
    for (const Polygon3& facet : facets_of(scene.polygons[s]))
      if (contains(facet, place.position))
        return "lies on the surface " + quoted_name(scene.surfaces[s].name) + "; a light has to be beside it";
  }
  return place.path ? path_problem(*place.path, place.position, place_text) : "";
}

}  // namespace hottel

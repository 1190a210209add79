#include "geometry/space/scene/moving_lights.h"

#include "geometry/light_motion.h"
#include "geometry/naming_light.h"
#include "kernel/exact_double.h"

namespace hottel {

LightPlace3 place_after(const LightPlace3& place, const Rational& time) {
  LightPlace3 result = place;
  result.rotation = {};
  result.path = {};
  const Vector3& rate = place.rotation;
  const Rational x = within_a_turn(rate.x * time), y = within_a_turn(rate.y * time), z = within_a_turn(rate.z * time);
  if (x != 0 || y != 0 || z != 0) {
    const Vector3& d = place.direction;
    const std::vector<double> axis = turned({d.x, d.y, d.z}, {x, y, z});
    result.direction = {exact_value(axis[0]), exact_value(axis[1]), exact_value(axis[2])};
  }
  if (!place.path) return result;
  std::vector<std::vector<Rational>> points;
  for (const Point3& p : place.path->points) points.push_back({p.x, p.y, p.z});
  const PathPlace at =
      place_on_path(points, place.path->closed, part_of_way(time, place.path->seconds, place.path->closed));
  result.position = {exact_value(at.point[0]), exact_value(at.point[1]), exact_value(at.point[2])};
  return result;
}

bool has_moving_lights(const Scene3& scene) {
  for (std::size_t k = 0; k < scene.lights.size(); ++k) {
    const LightPlace3& place = scene.light_places[k];
    if (place.path || (!place.rotation.is_zero() && !scene.lights[k].is_round())) return true;
  }
  return false;
}

Scene3 scene_after(Scene3 scene, const Rational& time) {
  for (std::size_t k = 0; k < scene.lights.size(); ++k) {
    const auto after = [&] { return place_after(scene.light_places[k], time); };
    scene.light_places[k] = naming_light(scene, scene.lights[k], after);
  }
  return scene;
}

}  // namespace hottel

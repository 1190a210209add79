#include "geometry/plane/scene/moving_lights.h"

#include "geometry/light_motion.h"
#include "geometry/naming_light.h"
#include "kernel/exact_double.h"

namespace hottel {

LightPlace2 place_after(const LightPlace2& place, const Rational& time) {
  LightPlace2 result = place;
  result.rotation = 0;
  result.path = {};
  if (place.rotation != 0) result.turned = within_a_turn(place.turned + place.rotation * time);
  if (!place.path) return result;
  std::vector<std::vector<Rational>> points;
  for (const Point2& p : place.path->points) points.push_back({p.x, p.y});
  const PathPlace at =
      place_on_path(points, place.path->closed, part_of_way(time, place.path->seconds, place.path->closed));
  result.position = {exact_value(at.point[0]), exact_value(at.point[1])};
  return result;
}

Point2 turned_direction(const LightPlace2& place) {
  if (const Rational quarters = place.turned / 90; quarters.get_den() == 1) {
    Point2 direction = place.direction;
    for (unsigned long k = mpz_fdiv_ui(quarters.get_num_mpz_t(), 4); k > 0; --k)
      direction = {-direction.y, direction.x};
    return direction;
  }
  const std::vector<double> turning = turned({place.direction.x, place.direction.y, 0}, {0, 0, place.turned});
  return {exact_value(turning[0]), exact_value(turning[1])};
}

bool has_moving_lights(const Scene2& scene) {
  for (std::size_t k = 0; k < scene.lights.size(); ++k) {
    const LightPlace2& place = scene.light_places[k];
    if (place.path || (place.rotation != 0 && !scene.lights[k].is_round())) return true;
  }
  return false;
}

Scene2 scene_after(Scene2 scene, const Rational& time) {
  for (std::size_t k = 0; k < scene.lights.size(); ++k) {
    const auto after = [&] { return place_after(scene.light_places[k], time); };
    scene.light_places[k] = naming_light(scene, scene.lights[k], after);
  }
  return scene;
}

}  // namespace hottel

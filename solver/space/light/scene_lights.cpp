#include "solver/space/light/scene_lights.h"

#include "geometry/unit_of_length.h"
#include "solver/space/light/scene_light_shares.h"

namespace hottel {
namespace {

void add_share(double share, const std::array<double, 3>& power, std::span<double> result) {
  if (share == 0) return;
  for (std::size_t c = 0; c < result.size(); ++c)
    if (power[c] > 0) result[c] += share * power[c];
}

}  // namespace

SceneLights3::SceneLights3(const PreparedScene3& prepared) {
  const Scene3& scene = prepared.scene;
  for (std::size_t k = 0; k < scene.lights.size(); ++k) {
    const LightPlace3& place = scene.light_places[k];
    Lamp& lamp = lamps_.emplace_back();
    lamp.light = scene.lights[k].is_sun()
                     ? std::make_unique<const DirectLight3>(prepared, place.direction)
                     : std::make_unique<const DirectLight3>(prepared, place.position, beam_of(scene.lights[k], place));
    lamp.power = power_by_typed_distance_3(scene, scene.lights[k]);
  }
}

void SceneLights3::add(const Point3& point, std::span<double> result) const {
  for (const Lamp& lamp : lamps_) add_share(lamp.light->mean_irradiance(point), lamp.power, result);
}

void SceneLights3::add(const Point3& point, const Vector3& normal, std::span<double> result) const {
  for (const Lamp& lamp : lamps_) add_share(lamp.light->irradiance(point, normal), lamp.power, result);
}

}  // namespace hottel

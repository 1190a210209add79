#include "viewer/window/space/first_light.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "geometry/space/visibility/direction.h"

namespace hottel {
namespace {

constexpr double kPaleSky = 0.8, kDarkSide = 0.04, kDarkest = 0.25;  // of a form

std::size_t channels_of(const Scene3& scene) {
  return scene.has_bands ? 1 : static_cast<std::size_t>(channel_count(scene));
}

// How bright a face is by its slope, 1 at most: a little more from above.
double slope_light(const Scene3& scene, const Element& element) {
  constexpr double kAmbient = 0.65, kAbove = 0.35;
  static const Direction3 kFrom = unit({1, -2, 3});
  const Vector3 area = doubled_area(scene.polygons[element.surface]);
  const Direction3 front = unit({to_double(area.x), to_double(area.y), to_double(area.z)});
  return kAmbient + kAbove * (element.is_back ? -1 : 1) * dot(front, kFrom);
}

}  // namespace

ElementPaint3 light_before_factors_3(const Scene3& scene, const ElementTable3& table) {
  ElementPaint3 paint;
  paint.channels = channels_of(scene);
  std::vector<double> emission(scene.materials.size()), reflectivity(scene.materials.size());
  std::vector<double> by_channel(table.count() * paint.channels, 0);
  for (std::size_t c = 0; c < paint.channels; ++c) {
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
      emission[m] = to_double(scene.materials[m].emission.value[c]);
      reflectivity[m] = to_double(scene.materials[m].reflectivity.value[c]);
    }
    const double sky = to_double(scene.sky_emission.value[c]);
    double sent = 0, lost = 0, of_suns = 0;
    for (const Light& light : scene.lights) (light.is_sun() ? of_suns : sent) += to_double(light.power.value[c]);
    for (std::uint32_t i = 0; i < table.count(); ++i) {
      if (!table.has_row(i)) continue;
      const Element& element = table.elements()[i];
      sent += element.area.value * emission[*element.material];
      lost += element.area.value * (1 - reflectivity[*element.material]);
    }
    const double mean = (lost > 0 ? sent / lost : 0) + sky / 2 + of_suns / 4;
    for (std::uint32_t i = 0; i < table.count(); ++i) {
      if (!table.has_row(i)) continue;
      const Element& element = table.elements()[i];
      const double light = mean * slope_light(scene, element);
      by_channel[i * paint.channels + c] = emission[*element.material] + reflectivity[*element.material] * light;
    }
    paint.sky.push_back(sky);
  }
  paint.values = std::move(by_channel);
  paint.unknown.assign(paint.channels, 0);
  paint.black.assign(paint.channels, 0);
  return paint;
}

ElementPaint3 form_of_3(const Scene3& scene, const ElementTable3& table) {
  ElementPaint3 paint;
  paint.channels = channels_of(scene);
  paint.values.assign(table.count() * paint.channels, 0);
  for (std::uint32_t i = 0; i < table.count(); ++i) {
    if (!table.has_row(i)) continue;
    const Element& element = table.elements()[i];
    const Spectrum& reflectivity = scene.materials[*element.material].reflectivity;
    for (std::size_t c = 0; c < paint.channels; ++c)
      paint.values[i * paint.channels + c] =
          slope_light(scene, element) * std::max(kDarkest, to_double(reflectivity.value[c]));
  }
  paint.unknown.assign(paint.channels, kDarkSide);
  paint.black.assign(paint.channels, kDarkSide);
  paint.sky.assign(paint.channels, kPaleSky);
  return paint;
}

}  // namespace hottel

#include "viewer/window/space/first_light.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
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

// Light of the elements of a face, and their areas.
struct FaceLight {
  std::vector<double> area, values;  // values: channel by channel of each

  double mean(std::size_t channel, std::size_t channels) const {
    double sum = 0, whole = 0;
    for (std::size_t k = 0; k < area.size(); ++k) {
      sum += area[k] * values[k * channels + channel];
      whole += area[k];
    }
    return whole > 0 ? sum / whole : 0;
  }
};

using FaceName = std::pair<std::string, bool>;
FaceName face_of_element(const ElementLight3& of, std::uint32_t i) {
  const Element& element = of.table.elements()[i];
  return {of.scene.surfaces[element.surface].name, element.is_back};
}

std::map<FaceName, FaceLight> light_by_face(const ElementLight3& of) {
  std::map<FaceName, FaceLight> faces;
  const std::size_t channels = of.paint.channels;
  for (std::uint32_t i = 0; i < of.table.count(); ++i) {
    if (!of.table.has_row(i)) continue;
    FaceLight& face = faces[face_of_element(of, i)];
    face.area.push_back(of.table.elements()[i].area.value);
    const auto its = of.paint.values.begin() + static_cast<std::ptrdiff_t>(i * channels);
    face.values.insert(face.values.end(), its, its + static_cast<std::ptrdiff_t>(channels));
  }
  return faces;
}

}  // namespace

void carry_light_3(const ElementLight3& before, const Scene3& scene, const ElementTable3& table, ElementPaint3& light) {
  const std::size_t channels = light.channels;
  if (before.paint.channels != channels) return;
  const ElementLight3 now{scene, table, light};
  const std::map<FaceName, FaceLight> then = light_by_face(before), here = light_by_face(now);
  std::map<FaceName, std::size_t> next;  // how many elements of a face have been given light
  for (std::uint32_t i = 0; i < now.table.count(); ++i) {
    if (!now.table.has_row(i)) continue;
    const FaceName name = face_of_element(now, i);
    const auto found = then.find(name);
    const std::size_t part = next[name]++;
    if (found == then.end()) continue;
    const bool is_alike = found->second.area.size() == here.at(name).area.size();
    for (std::size_t c = 0; c < channels; ++c)
      light.values[i * channels + c] =
          is_alike ? found->second.values[part * channels + c] : found->second.mean(c, channels);
  }
}

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

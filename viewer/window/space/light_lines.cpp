#include "viewer/window/space/light_lines.h"

#include "kernel/decimal.h"
#include "viewer/edit/material_edits.h"

namespace hottel {

std::string coordinates_text_3(const Point3& p) {
  return short_text(p.x) + ", " + short_text(p.y) + ", " + short_text(p.z);
}

std::vector<std::string> light_lines_3(const Scene3& scene, std::uint32_t light) {
  const Light& values = scene.lights[light];
  const LightPlace3& place = scene.light_places[light];
  const auto vector = [](const Vector3& v) { return coordinates_text_3({v.x, v.y, v.z}); };
  if (values.is_sun())
    return {values.name, "irradiance\t" + spectrum_text(values.power), "direction\t" + vector(place.direction),
            "rotation\t" + vector(place.rotation)};
  std::vector<std::string> lines{values.name, "position\t" + coordinates_text_3(place.position),
                                 "power\t" + spectrum_text(values.power)};
  if (values.type == LightType::kPoint) return lines;
  lines.push_back("direction\t" + vector(place.direction));
  lines.push_back("focus\t" + short_text(values.focus));
  lines.push_back("falloff\t" + short_text(values.falloff));
  lines.push_back("rotation\t" + vector(place.rotation));
  return lines;
}

}  // namespace hottel

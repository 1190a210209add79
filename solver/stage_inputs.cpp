#include "solver/stage_inputs.h"

#include <algorithm>

#include "kernel/support/failure.h"

namespace hottel {

bool operator==(const Spectra& a, const Spectra& b) {
  return std::ranges::equal(a.values, b.values,
                            [](const Spectrum& s, const Spectrum& t) { return s == t && s.is_scalar == t.is_scalar; });
}

Spectra powers_of(const SceneTable& scene) {
  Spectra spectra;
  for (const Light& light : scene.lights) spectra.values.push_back(light.power);
  return spectra;
}

Spectra emissions_of(const SceneTable& scene) {
  Spectra spectra;
  for (const Material& material : scene.materials) {
    spectra.values.push_back(material.emission);
    if (material.has_given_flux()) spectra.values.push_back(material.surface_reflectivity());
    if (material.has_bands)
      spectra.values.push_back(Spectrum::scalar((material.keeps_gains() ? 2 : 0) + (material.says_solar ? 1 : 0)));
  }
  spectra.values.push_back(scene.sky_emission);
  return spectra;
}

bool are_alike_as_before(const std::vector<Material>& before, const std::vector<Material>& now) {
  HOTTEL_REQUIRE(before.size() == now.size());
  for (std::size_t a = 0; a < now.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      if ((before[a] == before[b]) != (now[a] == now[b])) return false;
  return true;
}

std::vector<Light> beams_of(std::vector<Light> lights) {
  for (Light& light : lights) {
    light.power = {};
    light.line = 0;
  }
  return lights;
}

}  // namespace hottel

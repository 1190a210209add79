#include "solver/check/kelvin_hint.h"

#include <vector>

#include "geometry/gray_temperature.h"
#include "geometry/name.h"

namespace hottel {
namespace {

bool sees_sky(const ExchangeMatrix& matrix) {
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    if (matrix.has_row(i) && matrix.factor(i, matrix.sky()).value > 0) return true;
  return false;
}

bool is_colder(const Spectrum& sky, const Rational& temperature) {
  const Spectrum own = black_emission(Spectrum::scalar(temperature));
  for (std::size_t c = 0; c < 3; ++c)
    if (sky.value[c] < own.value[c]) return true;
  return false;
}

}  // namespace

std::optional<std::string> kelvin_hint(const SceneTable& scene, const ExchangeMatrix* matrix) {
  const bool has_sky = !scene.closed && (matrix == nullptr || sees_sky(*matrix));
  std::vector<char> is_used(scene.materials.size(), 0);
  for (const Surface& surface : scene.surfaces)
    for (const bool is_back : {false, true})
      if (const auto material = surface.material_of(is_back)) is_used[*material] = 1;
  std::string found;
  for (std::size_t m = 0; m < is_used.size(); ++m) {
    const Material& material = scene.materials[m];
    if (is_used[m] == 0 || material.emission.is_zero()) continue;
    const auto temperature = gray_temperature(material);
    if (!temperature || *temperature <= 0 || *temperature >= 100) continue;
    if (has_sky && is_colder(scene.sky_emission, *temperature)) continue;
    found +=
        (found.empty() ? "" : ", ") + quoted_name(material.name) + " (" + shortest(to_double(*temperature)) + " K)";
  }
  if (found.empty()) return std::nullopt;
  return "these are colder than 100 K: " + found;
}

}  // namespace hottel

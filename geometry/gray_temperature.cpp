#include "geometry/gray_temperature.h"

namespace hottel {
namespace {

// The rational whose fourth power it is, if there is one.
std::optional<Rational> fourth_root(const Rational& power) {
  Integer numerator, denominator;
  if (mpz_root(numerator.get_mpz_t(), power.get_num_mpz_t(), 4) == 0) return std::nullopt;
  if (mpz_root(denominator.get_mpz_t(), power.get_den_mpz_t(), 4) == 0) return std::nullopt;
  return Rational(numerator, denominator);
}

}  // namespace

std::optional<Rational> gray_temperature(const Material& material) {
  static const Rational of_one_kelvin = black_emission(Spectrum::scalar(1)).value[0];
  std::optional<Rational> result;
  for (std::size_t c = material.has_bands ? kThermalBand : 0; c < material.emission.value.size(); ++c) {
    const Rational emissivity = 1 - material.reflectivity.value[c];
    if (emissivity == 0 && material.emission.value[c] == 0) continue;
    if (emissivity == 0) return std::nullopt;
    const auto found = fourth_root(material.emission.value[c] / (emissivity * of_one_kelvin));
    if (!found || (result && *result != *found)) return std::nullopt;
    result = found;
  }
  return result;
}

}  // namespace hottel

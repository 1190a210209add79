#include "solver/radiosity/grey_temperature.h"

#include <cmath>

namespace hottel {
namespace {

// What a black body of 1 K sends out: sigma.
const Rational& stefan_boltzmann() {
  static const Rational sigma = [] {
    Material black;
    set_grey_body(Spectrum::scalar(1), Spectrum::scalar(1), black);
    return black.emission.value[0];
  }();
  return sigma;
}

// The rational whose fourth power it is, if there is one.
std::optional<Rational> fourth_root(const Rational& power) {
  Integer numerator, denominator;
  if (mpz_root(numerator.get_mpz_t(), power.get_num_mpz_t(), 4) == 0) return std::nullopt;
  if (mpz_root(denominator.get_mpz_t(), power.get_den_mpz_t(), 4) == 0) return std::nullopt;
  return Rational(numerator, denominator);
}

}  // namespace

std::optional<Rational> grey_temperature(const Material& material) {
  std::optional<Rational> result;
  for (std::size_t c = 0; c < material.emission.value.size(); ++c) {
    const Rational emissivity = 1 - material.reflectivity.value[c];
    if (emissivity == 0 && material.emission.value[c] == 0) continue;
    if (emissivity == 0) return std::nullopt;
    const auto found = fourth_root(material.emission.value[c] / (emissivity * stefan_boltzmann()));
    if (!found || (result && *result != *found)) return std::nullopt;
    result = found;
  }
  return result;
}

double black_temperature(double power) {
  static const double sigma = to_double(stefan_boltzmann());
  return std::sqrt(std::sqrt(power / sigma));
}

}  // namespace hottel

#include "geometry/material.h"

#include <algorithm>

#include "geometry/name.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// sigma in W/(m² K⁴).
const Rational& stefan_boltzmann() {
  static const Rational sigma = *parse_rational("5.670374419e-8");
  return sigma;
}

}  // namespace

std::string material_name_problem(std::string_view name) {
  if (name.empty()) return "the name of a material must not be empty";
  if (has_control_character(name))
    return "the name of material " + quoted_name(name) + " must not contain a control character";
  return "";
}

std::string_view spectrum_problem(const Spectrum& spectrum, SpectrumKind kind) {
  const bool is_fraction = kind == SpectrumKind::kFraction;
  const bool is_in_range = std::all_of(spectrum.value.begin(), spectrum.value.end(),
                                       [&](const Rational& v) { return sgn(v) >= 0 && (!is_fraction || v <= 1); });
  return is_in_range ? "" : is_fraction ? "must be from 0 to 1" : "must not be negative";
}

bool Material::is_adiabatic() const {
  if (has_bands) return thermal(reflectivity) == 1 && thermal(emission) == 0;
  return reflectivity == Spectrum::scalar(1) && emission.is_zero();
}

bool Material::has_given_flux() const {
  if (has_bands) return emissivity && thermal(reflectivity) == 1;
  return emissivity && emission.is_scalar && reflectivity == Spectrum::scalar(1);
}

Spectrum Material::surface_reflectivity() const {
  if (!has_given_flux()) return reflectivity;
  const Rational rho = 1 - *emissivity;
  return has_bands ? in_bands(reflectivity.value[kSolarBand], rho) : Spectrum::scalar(rho);
}

Rational Material::resistance() const {
  if (!has_given_flux()) return 0;
  return (1 - *emissivity) / *emissivity;
}

Rational Material::surface_emissivity() const {
  const Spectrum surface = surface_reflectivity();
  if (has_bands) return 1 - thermal(surface);
  return 1 - (surface.value[0] + surface.value[1] + surface.value[2]) / 3;
}

Spectrum in_bands(const Rational& solar, const Rational& thermal) { return {{solar, thermal, thermal}, false}; }

void set_bands(const Rational& solar_reflectivity, const Rational& solar_emission, Material& material) {
  HOTTEL_REQUIRE(material.reflectivity.is_scalar && material.emission.is_scalar);
  material.reflectivity = in_bands(solar_reflectivity, material.reflectivity.value[0]);
  material.emission = in_bands(solar_emission, material.emission.value[0]);
  material.has_bands = true;
}

Spectrum black_emission(const Spectrum& temperature) {
  Spectrum result{{}, temperature.is_scalar};
  for (std::size_t c = 0; c < 3; ++c) {
    const Rational& t = temperature.value[c];
    result.value[c] = stefan_boltzmann() * t * t * t * t;
  }
  return result;
}

void set_insulated(Material& material) {
  material.reflectivity = Spectrum::scalar(1);
  material.emission = Spectrum();
  material.called_insulated = true;
}

void set_given_flux(const Rational& emissivity, const Rational& flux, Material& material) {
  HOTTEL_REQUIRE(emissivity > 0 && emissivity <= 1);
  material.reflectivity = Spectrum::scalar(1);
  material.emission = Spectrum::scalar(flux);
  material.emissivity = emissivity;
}

void set_gray_body(const Spectrum& emissivity, const Spectrum& temperature, Material& material) {
  const Spectrum black = black_emission(temperature);
  material.reflectivity.is_scalar = emissivity.is_scalar;
  material.emission.is_scalar = emissivity.is_scalar && temperature.is_scalar;
  for (std::size_t c = 0; c < 3; ++c) {
    material.reflectivity.value[c] = 1 - emissivity.value[c];
    material.emission.value[c] = emissivity.value[c] * black.value[c];
  }
}

}  // namespace hottel

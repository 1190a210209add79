// How a face reflects and emits.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "kernel/rational.h"

namespace hottel {

// A quantity for each channel, exact. A scalar is one value for all channels.
//
//   (1) spectra are equal if their three values are; is_scalar, which says how it was given, is not compared
//   (2) the default is the scalar 0
struct Spectrum {
  std::array<Rational, 3> value{0, 0, 0};
  bool is_scalar = true;

  static Spectrum scalar(const Rational& v) { return {{v, v, v}, true}; }
  bool is_zero() const { return value[0] == 0 && value[1] == 0 && value[2] == 0; }
  friend bool operator==(const Spectrum& a, const Spectrum& b) { return a.value == b.value; }
};

// In a scene with two bands, channel 0 of a spectrum is solar, channel 1 thermal; channel 2 repeats channel 1.
inline constexpr std::size_t kSolarBand = 0, kThermalBand = 1;

// A diffuse material: 0 <= reflectivity <= 1 in every channel; emission >= 0 [W/m²], or of any sign if it is a given
// net flux. validate_table() checks these ranges. Emissivity e and temperature T in a scene file become reflectivity
// 1 - e and emission e sigma T⁴, exactly.
//
//   (1) the default is black and emits nothing
//   (2) an insulated material (heat leaves it by radiation alone) has reflectivity 1, emission 0, and the flag
//       called_insulated. It acts as any material with these values, but see (4); with other values the flag is void
//   (3) with a given net flux q (set_given_flux) reflectivity is 1 and emission is q, so that B = q + H: that is
//       how it acts on light. The emissivity e of its surface gives the temperature:
//       sigma T⁴ = B + (1 - e) q / e.
//       If the reflectivity is not 1, or the emission differs by channel, emissivity is void
//   (4) in two bands (set_bands) temperatures, insulation and given fluxes concern the thermal band
//       alone. An insulated face then sends out what arrives and what it gains in the solar band, as a
//       face of given flux 0 does, and may have an emissivity
//   (5) a two-sided material acts like any other: the flag only tells which backs have it (settle_two_sided)
struct Material {
  std::string name;
  Spectrum reflectivity;
  Spectrum emission;
  bool called_insulated = false;
  std::optional<Rational> emissivity{};
  bool has_bands = false;     // its spectra are of two bands
  bool says_solar = false;    // of which the solar one was said, and is not black because nothing was
  bool is_two_sided = false;  // surfaces with it have it on their backs too, but for those that have another one there

  // True iff it reflects everything that arrives, in all channels, and emits nothing.
  bool is_adiabatic() const;
  bool is_insulated() const { return called_insulated && is_adiabatic(); }
  // True iff its net flux is given, or it is insulated with an emissivity: then its temperature is a result.
  bool has_given_flux() const;
  // True iff what it gains in the solar band is heat that it must give away in the thermal one.
  bool keeps_gains() const { return has_bands && (is_insulated() || has_given_flux()); }
  // The value of a spectrum that temperatures depend on: that of the thermal band, or of any channel.
  const Rational& thermal(const Spectrum& spectrum) const { return spectrum.value[has_bands ? kThermalBand : 0]; }
  // The reflectivity of its surface: 1 - e if a net flux is given, else its reflectivity.
  Spectrum surface_reflectivity() const;
  // How much more than it a black body of its temperature emits, for each W/m² of its net flux: (1 - e) / e
  // if an emissivity is given, else 0.
  Rational resistance() const;
  // The same for the flux that is given: (1 - e) q / e.
  Rational power_above_radiosity() const { return resistance() * thermal(emission); }
  // The emissivity of its surface; the mean of three channels.
  Rational surface_emissivity() const;

  // The name is not compared: two materials are equal when they act alike.
  friend bool operator==(const Material& a, const Material& b) {
    return a.reflectivity == b.reflectivity && a.emission == b.emission && a.has_given_flux() == b.has_given_flux() &&
           (!a.has_given_flux() || a.emissivity == b.emissivity) && a.has_bands == b.has_bands &&
           a.keeps_gains() == b.keeps_gains();
  }
};

// Returns why a material may not be called so, as a sentence; empty when it may. It only has to print on one line.
std::string material_name_problem(std::string_view name);

// What a spectrum measures: fractions are from 0 to 1, other quantities at least 0.
enum class SpectrumKind : bool { kFraction, kQuantity };
// Returns what is wrong with a spectrum, as the end of a sentence ("must be from 0 to 1"); empty when nothing is.
std::string_view spectrum_problem(const Spectrum& spectrum, SpectrumKind kind);

// Returns the emission of a black body of this temperature [K]: sigma T⁴, exactly.                              [W/m²]
Spectrum black_emission(const Spectrum& temperature);

// Makes a material insulated: reflectivity 1 and emission 0, of one value for all channels.
void set_insulated(Material& material);

// Gives a material a net flux [W/m²] of any sign, and its surface an emissivity: reflectivity 1 and emission `flux`, of
// one value for all channels. REQUIRES 0 < emissivity <= 1.
void set_given_flux(const Rational& emissivity, const Rational& flux, Material& material);

// Turns the scalar spectra of a material into spectra of two bands; the old values become thermal. REQUIRES scalars.
void set_bands(const Rational& solar_reflectivity, const Rational& solar_emission, Material& material);
// A spectrum of two bands.
Spectrum in_bands(const Rational& solar, const Rational& thermal);

// Makes a material a gray body: reflectivity 1 - e and emission e sigma T⁴, exactly, sigma = 5.670374419e-8 W/(m² K⁴).
void set_gray_body(const Spectrum& emissivity, const Spectrum& temperature, Material& material);

}  // namespace hottel

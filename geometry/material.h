// How a face reflects and emits.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "kernel/rational.h"

namespace hottel {

// A quantity per channel, exact. A scalar holds for every channel.
//
//   (1) equal where the three values are: is_scalar says how it was given, and is not compared
//   (2) the default is the scalar 0
struct Spectrum {
  std::array<Rational, 3> value{0, 0, 0};
  bool is_scalar = true;

  static Spectrum scalar(const Rational& v) { return {{v, v, v}, true}; }
  bool is_zero() const { return value[0] == 0 && value[1] == 0 && value[2] == 0; }
  friend bool operator==(const Spectrum& a, const Spectrum& b) { return a.value == b.value; }
};

// Where a scene has two bands, spectra are of them: channel 0 is solar, channel 1 thermal; channel 2 is as channel 1.
inline constexpr std::size_t kSolarBand = 0, kThermalBand = 1;

// A diffuse material: 0 <= reflectivity <= 1 in every channel, emission >= 0 [W/m²], of any sign where
// a net flux is given. validate_table() checks these ranges. Emissivity e and temperature T are read as reflectivity 1
// - e and emission e sigma T⁴, exactly.
//
//   (1) the default is black and emits nothing
//   (2) an insulated material (no heat leaves it but by radiation) is one with reflectivity 1 and emission 0 that was
//       called so: it acts as any such, and is written as it was called. Where the values are others the word is void
//   (3) where the net flux q is given (set_given_flux) reflectivity is 1 and emission is q, so that B = q + H: that is
//       how it acts on light. Its surface has the emissivity e, from which its temperature follows: sigma T⁴ =
//       B + (1 - e) q / e. Where the reflectivity is another, or the
//       emission differs by channel, emissivity is void
//   (4) in two bands (set_bands) all that is said of temperatures, of insulated faces and of given fluxes is of the
//       thermal band. An insulated face then sends out what arrives and what it gains in the solar band, as a face of
//       given flux 0 does, and may have an emissivity
//   (5) a two-sided material acts as any other does: what it says is about surfaces (settle_two_sided)
struct Material {
  std::string name;
  Spectrum reflectivity;
  Spectrum emission;
  bool called_insulated = false;
  std::optional<Rational> emissivity{};
  bool has_bands = false;     // its spectra are of two bands
  bool says_solar = false;    // of which the solar one was said, and is not black because nothing was
  bool is_two_sided = false;  // surfaces with it have it on their backs too, but for those that have another one there

  // Whether it sends back all that arrives, in all channels, and nothing of its own.
  bool is_adiabatic() const;
  bool is_insulated() const { return called_insulated && is_adiabatic(); }
  // Whether its net flux is given, or the emissivity of an insulated face, and its temperature is what comes out.
  bool has_given_flux() const;
  // Whether what it gains in the solar band is heat that it must give away in the thermal one.
  bool keeps_gains() const { return has_bands && (is_insulated() || has_given_flux()); }
  // The value of its spectra that temperatures are about: of the thermal band, or of any channel.
  const Rational& thermal(const Spectrum& spectrum) const { return spectrum.value[has_bands ? kThermalBand : 0]; }
  // How its surface reflects: 1 - e where a net flux is given, else as it acts.
  Spectrum surface_reflectivity() const;
  // How much more a black body of its temperature sends out than it does, for each W/m² of its net flux: (1 - e) / e
  // where one is given, else 0.
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

// What a spectrum is for: fractions are from 0 to 1, other quantities not below 0.
enum class SpectrumKind : bool { kFraction, kQuantity };
// Returns what is wrong with a spectrum, as the end of a sentence ("must be from 0 to 1"); empty when nothing is.
std::string_view spectrum_problem(const Spectrum& spectrum, SpectrumKind kind);

// Returns what a black body of this temperature [K] sends out: sigma T⁴, exactly.                               [W/m²]
Spectrum black_emission(const Spectrum& temperature);

// Makes a material insulated: reflectivity 1 and emission 0, of one value for all channels.
void set_insulated(Material& material);

// Gives a material a net flux [W/m²] of any sign, and its surface an emissivity: reflectivity 1 and emission `flux`, of
// one value for all channels. REQUIRES 0 < emissivity <= 1.
void set_given_flux(const Rational& emissivity, const Rational& flux, Material& material);

// Makes the spectra of a material those of two bands, what they were being the thermal ones. REQUIRES scalars.
void set_bands(const Rational& solar_reflectivity, const Rational& solar_emission, Material& material);
// A spectrum of two bands.
Spectrum in_bands(const Rational& solar, const Rational& thermal);

// Makes a material a gray body: reflectivity 1 - e and emission e sigma T⁴, exactly, sigma = 5.670374419e-8 W/(m² K⁴).
void set_gray_body(const Spectrum& emissivity, const Spectrum& temperature, Material& material);

}  // namespace hottel

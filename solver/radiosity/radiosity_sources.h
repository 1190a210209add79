// What shines in a scene: emissions, and irradiance from light that is no part of it.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/material.h"
#include "kernel/enclosure.h"
#include "kernel/rational.h"

namespace hottel {

// A number that is known exactly, where lower = upper, or to lie between two.
struct RationalEnclosure {
  Rational lower = 0, upper = 0;

  bool is_exact() const { return lower == upper; }
  friend bool operator==(const RationalEnclosure&, const RationalEnclosure&) = default;
};

// Which number of an enclosure.
enum class End { kLower, kMiddle, kUpper };

// What one element sends out or receives in each channel, exactly or within bounds.       [W/m²]
//
//   (1) numbers of materials lose nothing: lower = upper is the rational itself
//   (2) the default is the scalar 0
//   (3) copies share their numbers
// Throws ContractViolation where a number is below 0 or not finite, or a lower end above the upper one.
class SourceSpectrum {
 public:
  SourceSpectrum() = default;
  SourceSpectrum(const Spectrum& exact);                  // implicit: a spectrum is one whose numbers are known
  static SourceSpectrum scalar(const Enclosure& within);  // the same in every channel
  static SourceSpectrum of(const std::array<Enclosure, 3>& within);  // red, green, blue
  static SourceSpectrum of(const std::array<RationalEnclosure, 3>& within);

  // The number of channel 0, 1 or 2. It stays where it is as long as a copy of this lives.
  const RationalEnclosure& operator[](int channel) const;
  bool is_scalar() const { return !numbers_ || numbers_->is_scalar; }

  // One number of each enclosure, exact.
  SourceSpectrum at(End end) const;

  // By value: scalars and spectra that were given by channel are told apart.
  friend bool operator==(const SourceSpectrum& a, const SourceSpectrum& b);

 private:
  struct Numbers {
    std::vector<RationalEnclosure> value;  // of all channels alike, or of each
    bool is_scalar = true;
  };
  explicit SourceSpectrum(Numbers numbers);

  std::shared_ptr<const Numbers> numbers_;  // none: 0
};

// Power that comes from no element and meets none that has a row.             [W; W per metre of depth in the plane]
struct PowerBesides {
  SourceSpectrum absorbed;  // by black backs, and in solids
  SourceSpectrum to_sky;
  // By channel: what was sent out and arrives nowhere; below 0, what arrives and was not sent out. A defect.
  std::array<Rational, 3> unaccounted{};
};

// The sources of a radiosity system: the right side of B_i = E_i + rho_i (sum_j F_ij B_j + D_i).
//
//   (1) E_i is what the element sends out by itself, D_i the irradiance by light that comes from no element and not
//       from the sky: of lamps that are no faces, of beams
//   (2) elements without a row are not looked at: they send out nothing, and what falls on them is nobody's
struct RadiositySources {
  std::vector<SourceSpectrum> emission;           // E, by element of the matrix
  std::vector<SourceSpectrum> direct_irradiance;  // D, by element of the matrix; empty: none
  SourceSpectrum sky;                             // what the sky sends out
  PowerBesides besides;                           // part of the energy, of nothing else
  bool has_channels = false;                      // red, green and blue even where every spectrum is a scalar
  // Net fluxes below 0, as numbers above 0, by element of the matrix; empty: none. A system that takes no sources of
  // both signs leaves them out; RadiositySolver solves for them apart.
  std::vector<SourceSpectrum> withdrawn;
  // Two bands, solar and thermal, instead of one channel or three. `keeps_gains`: by element of the matrix, whether
  // what it gains in the solar band is sent out, or withdrawn, in the thermal one, beside its emission there.
  bool has_bands = false;
  std::vector<char> keeps_gains{};
  std::optional<int> only_channel{};  // none: all; else others are not solved for, and are 0
  bool has_given_fluxes = false;      // for messages: some face has a material with a given net flux

  // The same with one number of each enclosure. COST: O(n), and as many rationals as there are distinct spectra.
  RadiositySources at(End end) const;
  // What is withdrawn, as the only source. has_channels as it is said.
  RadiositySources withdrawn_alone(bool in_channels) const;
  // All but the numbers: which channels there are, and who keeps gains.
  RadiositySources without_numbers() const;
};

// The sources of a scene: its faces emit as their materials do, and there is no other light.
//
//   (1) has_channels iff the emission of some material is no scalar, be there a face of it or not
//   (2) has_bands iff materials have bands
//   (3) a face whose material has a net flux below 0 emits nothing: the flux is withdrawn
// Throws ContractViolation where the material of a row is none of these.
RadiositySources sources_of(const ExchangeMatrix& matrix, const std::vector<Material>& materials,
                            const Spectrum& sky_emission);

// The reflectivities of materials, and those in one channel.
std::vector<Spectrum> reflectivities_of(const std::vector<Material>& materials);
std::vector<Rational> in_channel(const std::vector<Spectrum>& spectra, int channel);

}  // namespace hottel

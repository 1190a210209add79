// What follows for the elements of a scene from the radiosities of one channel.
#pragma once

#include <vector>

#include "solver/radiosity/certificate.h"
#include "solver/radiosity/printed_number.h"
#include "solver/radiosity/radiosity_solution.h"
#include "solver/radiosity/radiosity_system.h"

namespace hottel {

// Fills in the results of channels that share a system: radiosities, irradiances, net fluxes, energy.
//
//   (1) irradiance is what arrives from elements and the sky, and directly
//   (2) what arrives directly counts as emitted in the energy
// REQUIRES that all that it is made of outlives it.
class ChannelResults {
 public:
  // `reflectivity`: by material. is_refined: radiosities are as good as their factors, so that two forms of net agree.
  ChannelResults(const RadiositySystem& system, const std::vector<Rational>& reflectivity, bool is_refined);

  // `sources` are those of `channel` in the units of the system; `bounds` of all unknowns, and not looked at where
  // nothing is lit; both hold for the factors that are `meant`. `others` form some irradiances (null: none do).
  void fill(const RadiositySources& given, int channel, const Sources& sources, const CertifiedBounds& bounds,
            FactorsMeant meant, SharedRows* others, ChannelSolution& solution) const;

 private:
  // What is emitted and what arrives directly, by element, the sky last.
  struct Numbers {
    std::vector<Printed> emission;
    std::vector<ScaledBall> emitted, direct;
    ScaledBall absorbed_besides, to_sky_besides, unaccounted;
  };
  Numbers numbers_of(const RadiositySources& given, int channel) const;
  // Returns the radiosities, enclosed.
  std::vector<ScaledBall> fill_radiosities(const Numbers& numbers, const Sources& sources,
                                           const CertifiedBounds& bounds, ChannelSolution& solution) const;
  void fill_irradiances(const Numbers& numbers, const std::vector<ScaledBall>& radiosity,
                        const std::vector<ScaledBall>& exchange, ChannelSolution& solution) const;

  const RadiositySystem& system_;
  std::vector<double> reflectivity_;  // by material, correctly rounded
  std::vector<ScaledBall> loss_;      // by material: 1 - reflectivity
  bool is_refined_;
};

}  // namespace hottel

// Net flux of faces: the power that leaves them less the power that arrives, with proven bounds.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "solver/radiosity/direct_light.h"
#include "solver/radiosity/radiosity_solution.h"
#include "solver/radiosity/radiosity_sources.h"

namespace hottel {

// Of a face, or of several that go by one name: sum of A_i (B_i - H_i).      [W; in the plane W per metre of depth]
struct NetFlux {
  struct Power {
    double value = 0, lower = 0, upper = 0;
  };
  std::string name;
  std::optional<double> area;     // none: the sky, a light
  std::vector<Power> by_channel;  // as the channels of the solution
};

// The sum of two powers, bounds rounded outward.
NetFlux::Power sum(const NetFlux::Power& a, const NetFlux::Power& b);

// Lights, and what they shine on first.
struct ShiningLights {
  std::span<const Light> lights;
  std::span<const LightShares> shares;  // of each
};

// Returns the net flux of every face with a material and of every black back and the sky that such a face or a light
// sees, summed over the elements for which `name_of` returns the same name, in the order of the first of them; the sky
// last.
//
//   (1) positive: more leaves than arrives, as from a lamp; negative: the difference is absorbed, or goes to the sky
//   (2) lower <= true flux <= upper, and value lies between them; the same holds of sums over names. True is what the
//       bounds of the solution are about: the exact factors, all factors within their bounds, or, where some are
//       estimated (RadiositySolution::guarantee), those that the matrix holds
//   (3) the true fluxes of all names sum to 0 where rows sum to 1 and pairs are reciprocal: what is sent out arrives
//       somewhere; so do the values, but for roundings, where iterations were stopped early too. Lights are none of
//       them: with them they sum to minus what lights send out (light_flux)
// Throws ContractViolation where the solution has another number of elements. REQUIRES a solution of this matrix with
// this sky and these lights. COST: one pass over the matrix a channel.
std::vector<NetFlux> net_flux(const ExchangeMatrix& matrix, const RadiositySolution& solution,
                              const SourceSpectrum& sky_emission,
                              const std::function<std::string(const Element&)>& name_of,
                              const ShiningLights& shining = {});

// Returns the power of each light, in so many channels; of one in a solid 0, as nothing leaves it; of a sun what of it
// meets faces. What estimated shares lack or have too much is not told here.
std::vector<NetFlux> light_flux(const ShiningLights& shining, std::size_t channels);

}  // namespace hottel

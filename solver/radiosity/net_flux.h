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

// Of a face, or of faces with one name: sum of A_i (B_i - H_i).              [W; in the plane W per metre of depth]
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

// Lights, and the faces that they shine on directly.
struct ShiningLights {
  std::span<const Light> lights;
  std::span<const LightShares> shares;  // of each
};

// Returns the net fluxes of all faces with a material, of the black backs that such a face or a light sees, and of the
// sky. Elements for which `name_of` returns the same name are summed; names stand in the order of their first elements,
// the sky last.
//
//   (1) positive: more leaves than arrives, as at a lamp; negative: the difference is absorbed, or goes to the sky
//   (2) lower <= true flux <= upper, and value lies between them; the same holds of sums over names. True means what
//       the bounds of the solution hold for: the exact factors, all factors within their bounds, or, if some are
//       estimated (RadiositySolution::guarantee), the doubles of the matrix
//   (3) if rows sum to 1 and pairs are reciprocal, the true fluxes of all names sum to 0: all that is sent out arrives
//       somewhere. So do the values up to rounding, even if iterations were stopped early. Lights have no name here:
//       with lights the sum is minus what they send out (light_flux)
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

// Two bands: what faces gain in the solar band is heat that they give away in the thermal one.
#pragma once

#include "geometry/exchange_matrix.h"
#include "solver/radiosity/radiosity_solution.h"
#include "solver/radiosity/radiosity_sources.h"

namespace hottel {

// Returns the sources of the thermal band, once the solar one is solved: an element that keeps its gains sends out
// a = (1 - rho_s) H_s - E_s beside what it emits, or, where that is below 0, has it withdrawn.
//
//   (1) a is enclosed by the bounds of the solar net flux, of which it is the opposite: exact where that is, as where
//   no
//       light is absorbed; where a may be of either sign something may be sent out and something withdrawn
// Throws RequestError, naming an element, where its solar net flux has no bounds. REQUIRES sources with bands, `solar`
// the solution of their channel 0.
RadiositySources with_gains(const ExchangeMatrix& matrix, RadiositySources sources, const ChannelSolution& solar);

// Returns the solution whose channel 0 is that of `solar` and whose channel 1 is that of `thermal`. REQUIRES two
// solutions of the same system in two channels.
RadiositySolution in_one(RadiositySolution solar, RadiositySolution thermal);

}  // namespace hottel

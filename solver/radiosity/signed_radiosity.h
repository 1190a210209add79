// Radiosities of sources of both signs.
#pragma once

#include "geometry/exchange_matrix.h"
#include "solver/radiosity/radiosity_solution.h"

namespace hottel {

// Returns what a scene comes to in which some faces take heat: the solution of all that is supplied, less that of all
// that is withdrawn, each solved as a source by itself.
//
//   (1) bounds are the differences of bounds, rounded outward: they hold where those of both do; values lie within
//   (2) emission, irradiance and net flux are differences; an emission below 0 is heat that is taken
//   (3) in the energy what is withdrawn counts as absorbed, so that emitted = absorbed + to_sky + defect stays true
//   (4) dark are the components that are dark in both; notes, seconds, sizes are those of both, the history is that of
//       what is supplied, unless there is none
// REQUIRES two solutions of the same system, of as many channels.
RadiositySolution difference_of(const ExchangeMatrix& matrix, RadiositySolution supplied,
                                const RadiositySolution& withdrawn);

}  // namespace hottel

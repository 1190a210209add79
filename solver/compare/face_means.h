// Mean radiosities of whole faces: what divisions of one scene have in common.
#pragma once

#include <optional>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "solver/radiosity/radiosity_solution.h"

namespace hottel {

// By channel, then by face: 2 s the front of surface s, 2 s + 1 its back. Nothing for faces without a row.
using FaceMeans = std::vector<std::vector<std::optional<double>>>;

// Returns the mean over the area of each face. REQUIRES the solution of this matrix, by elements. COST: one pass.
FaceMeans face_mean_radiosities(const ExchangeMatrix& matrix, const RadiositySolution& solution);

// Returns the largest difference of two, of faces that both have, over the largest value of `finer`.
//
//   (1) 0 for equal ones, also in the dark; infinite where only `finer` is dark
// REQUIRES as many channels of both.
double face_mean_error(const FaceMeans& means, const FaceMeans& finer);

}  // namespace hottel

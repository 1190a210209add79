// Matrices of the least and of the largest factors there may be. Internal to solver/radiosity.
#pragma once

#include "geometry/exchange_matrix.h"

namespace hottel {

// Returns the same matrix with one end of the bounds of every entry as its factor: doubles, and nothing is said of
// them.
ExchangeMatrix matrix_of_ends(const ExchangeMatrix& matrix, double Enclosure::*end);

}  // namespace hottel

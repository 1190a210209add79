// Matrices of the least and of the largest factors there may be, and whether these may have closed rows. Internal to
// solver/radiosity.
#pragma once

#include "geometry/exchange_matrix.h"

namespace hottel {

// Returns the same matrix with one end of the bounds of every entry as its factor: doubles, and nothing is said of
// them.
ExchangeMatrix matrix_of_ends(const ExchangeMatrix& matrix, double Enclosure::*end);

// Returns whether bounds may be had from the defects of rows: factors are enclosed, their rows are closed, and pairs
// that may exchange light do so by their doubles too, which tell what is lit.
bool has_closed_enclosures(const ExchangeMatrix& matrix);

}  // namespace hottel

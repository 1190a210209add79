// Matrices of methods that fill one row after the other.
#pragma once

#include <functional>
#include <vector>

#include "solver/methods/element_geometry_2.h"

namespace hottel {

// Returns the estimated matrix with these rows, one for each element.
ExchangeMatrix matrix_of_rows(const ElementGeometry2& geometry, const std::vector<std::vector<FactorEntry>>& rows);

// Fills the row of an element: by[j] is 0 for every element j, the sky last, and receives F(from, j).
using FillRow = std::function<void(std::uint32_t from, std::vector<double>& by)>;

// Returns the matrix of all rows that elements with a place have, estimated; an entry for each factor that is not 0.
// COST: parallel over rows. Stops when it is interrupted.
ExchangeMatrix matrix_by_rows(const ElementGeometry2& geometry, const FillRow& fill);

}  // namespace hottel

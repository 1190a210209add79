// View factors of faces or groups from those of their elements.
#pragma once

#include "geometry/exchange_matrix.h"
#include "geometry/plane/arrangement/prepared_scene.h"
#include "geometry/plane/exchange/element_table.h"

namespace hottel {

// Returns F_IJ = sum over i in I of A_i / A_I times the sum over j in J of F_ij, as faces or groups of the scene are
// made of the matrix's elements: an estimate.
//
//   (1) row sums are means of row sums; reciprocity holds as far as it does among the elements
//   (2) visibilities are NaN: they were not asked for
// REQUIRES: a matrix over the elements of `prepared`. COST: the scene is prepared once more, undivided; one
// pass over the matrix.
ExchangeMatrix coarsened(const ExchangeMatrix& matrix, const PreparedScene2& prepared, Granularity granularity);

}  // namespace hottel

// View factors of faces or groups from those of their elements.
#pragma once

#include "geometry/exchange_matrix.h"
#include "geometry/scene_table.h"

namespace hottel {

// Returns F_IJ = sum over i in I of A_i / A_I times the sum over j in J of F_ij: an estimate.
//
//   (1) row sums are means of row sums; reciprocity holds as far as it does among the elements
//   (2) visibilities are NaN: they were not asked for
// whole: the faces or, with Granularity::kGroup, the groups that the elements of the matrix make up. REQUIRES: a matrix
// over the elements of the scene. COST: one pass over the matrix.
ExchangeMatrix coarsened(const ExchangeMatrix& matrix, const SceneTable& scene, const std::vector<Element>& whole,
                         Granularity granularity);

}  // namespace hottel

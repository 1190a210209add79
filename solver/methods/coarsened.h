// View factors of faces or groups from those of their elements.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/scene_table.h"

namespace hottel {

// Returns F_IJ = sum over i in I of A_i / A_I times the sum over j in J of F_ij, where element i and the sky are in
// label_of[i] of `whole`: an estimate. Every number of label_of is that of an element of `whole`, but that of the sky,
// the last, which is their count.
//
//   (1) as those of coarsened()
// COST: one pass over the matrix, in parallel, and a list as long as `whole` a thread.
ExchangeMatrix merged_matrix(const ExchangeMatrix& matrix, std::span<const std::uint32_t> label_of,
                             std::vector<Element> whole);

// Returns F_IJ = sum over i in I of A_i / A_I times the sum over j in J of F_ij: an estimate.
//
//   (1) row sums are means of row sums; reciprocity holds as far as it does among the elements
//   (2) visibilities are NaN: they were not asked for
// whole: the faces or, with Granularity::kGroup, the groups that the elements of the matrix make up. REQUIRES: a matrix
// over the elements of the scene. COST: one pass over the matrix.
ExchangeMatrix coarsened(const ExchangeMatrix& matrix, const SceneTable& scene, const std::vector<Element>& whole,
                         Granularity granularity);

}  // namespace hottel

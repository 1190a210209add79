// Why a pair of elements in space is hard: how much of it is hidden, how near and at what angle they are.
#pragma once

#include "geometry/exchange_matrix.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "solver/compare/explained_pair.h"
#include "solver/space/methods/element_geometry.h"

namespace hottel {

// Explains pairs of one scene. Visibilities are the exact ones; distances and angles are doubles, those of the largest
// patch of each element.
class PairExplainer3 {
 public:
  // exact: the scene's factors by elements, with visibilities. Both outlive this.
  PairExplainer3(const PreparedScene3& prepared, const ExchangeMatrix& exact);

  // reason is made of
  //   "they do not face each other" | "hidden" | "partly hidden" | "in full view", for the sky with "toward the sky",
  //   "touching" (a common corner) | "near" (nearer than the larger of the two is wide) | "far", not for the sky,
  //   "missed" (the method sees nothing of it) | "light where there is none".
  //
  //   (1) visibility is nothing only where no part of one faces any part of the other, and 0 where all that does is
  //       hidden
  // COST: a search in a row of the exact matrix; where the pair has no entry, all patches of both elements.
  PairExplanation explain(const PairError& pair) const;

 private:
  std::optional<double> visibility(std::uint32_t from, std::uint32_t to) const;

  const PreparedScene3& prepared_;
  const ExchangeMatrix& exact_;
  ElementGeometry3 geometry_;
  double unit_;  // of the geometry, in units of the scene
};

}  // namespace hottel

// Why a pair of elements is hard: how much of it is hidden, how near and at what angle they are.
#pragma once

#include <optional>

#include "geometry/exchange_matrix.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "solver/compare/explained_pair.h"

namespace hottel {

// Explains pairs of one scene. Visibilities are the exact ones; distances and angles are doubles, of the lines as
// typed: what other surfaces own of an element is not cut off.
class PairExplainer2 {
 public:
  // exact: the scene's factors by elements, with visibilities. Both outlive this.
  PairExplainer2(const PreparedScene2& prepared, const ExchangeMatrix& exact);

  // reason is made of
  //   "they do not face each other" | "hidden" | "partly hidden" | "in full view", for the sky with "toward the sky",
  //   "touching" (a common end) | "near" (nearer than the longer of the two is long) | "far", not for the sky,
  //   "missed" (the method sees nothing of it) | "light where there is none".
  //
  //   (1) visibility is nothing only where no part of one faces any part of the other, and 0 where all
  //       that does is hidden
  //   (2) "touching" is decided on exact ends
  // COST: a search in a row of the exact matrix; where the pair has no entry, all runs of both elements.
  PairExplanation explain(const PairError& pair) const;

 private:
  std::optional<double> visibility(std::uint32_t from, std::uint32_t to) const;

  const PreparedScene2& prepared_;
  const ExchangeMatrix& exact_;
  const ElementTable2& table_;
};

}  // namespace hottel

// What is asked of the exact view factors.
#pragma once

#include <cstdint>
#include <functional>

#include "geometry/plane/exchange/element_table.h"

namespace hottel {

// What is asked of exact_exchange().
//
//   (1) no option changes a number that is computed with and without it: options choose rows and columns, leave out
//       what nobody asks for, and limit what the computation may take
//   (2) a limit of memory is held against an estimate before the sweep, and against the pairs found during it
//
// REQUIRES: occlusion is left out for convex rooms only (is_convex_room).
struct ExchangeOptions2 {
  Granularity granularity = Granularity::kFace;
  bool wants_visibility = true;  // else FactorEntry::visibility is NaN
  bool wants_measures = false;   // ExchangeMatrix::measures()
  bool occlusion = true;         // false: nothing can hide anything (is_convex_room); no sweep is made
  std::uint64_t memory = 0;      // bytes the sums and the matrix may take; 0: no limit. Beyond: RequestError
  std::function<void(double)> progress = {};  // fraction of the sweep done; may throw to stop. No sweep, no call
};

}  // namespace hottel

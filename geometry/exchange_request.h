// What is asked of whoever computes view factors.
#pragma once

#include <cstdint>
#include <functional>

#include "geometry/element.h"
#include "geometry/row_choice.h"

namespace hottel {

// How an element's factor to the sky is found.
enum class SkyBy : unsigned char {
  kIntegral,  // it is measured as all others are
  kClosure,   // it is what all others leave of the area: SkyByClosure says of which rows
};

// What is asked of a computation of view factors, by whatever method and in whatever dimension.
//
//   (1) nothing here changes a number that is computed with and without it, but for the tolerance, and the sky by
//       closure: a request chooses rows and columns, leaves out what nobody asks for, and limits what the computation
//       may take
//   (2) a limit of memory is held against an estimate before the work, and against the pairs found during it. Methods
//       that are not exact keep to none
//   (3) a method that has no visibilities or measures leaves them out
struct ExchangeRequest {
  Granularity granularity = Granularity::kFace;
  bool wants_visibility = true;  // else FactorEntry::visibility is NaN
  bool wants_measures = false;   // ExchangeMatrix::measures()
  bool always_sweeps = false;    // also where nothing can hide anything (a convex room): the same numbers, slower
  // What S may be off, relative to the smaller of both areas, where a method can choose. Those of the plane cannot: the
  // exact one rounds correctly, the others are as good as they are.
  double tolerance = 1e-9;
  // Whether bounds of all pairs are to be as narrow as the tolerance, where that can be proven, by the exact method in
  // space: other numbers are the same but where they are told better so.
  bool proves = false;
  SkyBy sky = SkyBy::kIntegral;  // of the exact method in space; that of the plane is exact
  // The rows that are computed by the exact methods: all others have no entries. Methods that are not exact compute
  // all.
  RowChoice rows = {};
  std::uint64_t memory = 0;  // bytes the sums and the matrix may take; 0: no limit. Beyond: RequestError
  std::function<void(double)> progress = {};  // fraction done, from any thread; may throw to stop
};

}  // namespace hottel

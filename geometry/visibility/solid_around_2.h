// Whether a point lies in a solid, by what it sees.
#pragma once

#include <algorithm>

#include "geometry/arrangement/solids_2.h"
#include "geometry/visibility/view_2.h"

namespace hottel {

// Returns the first listed group of those that make solid what is seen around an eye; Solids2::kNone unless the eye
// lies in the interior of the union of all solids.
//
//   (1) exact: from there one sees covered sides only; from anywhere else, the border of a solid too, something else
// REQUIRES the view from the eye.
// COST: one look-up in the open; nothing in a scene without solids.
inline std::uint32_t solid_around(const Solids2& solids, const View2& view) {
  if (solids.is_empty() || view.seen.empty()) return Solids2::kNone;
  std::uint32_t first = Solids2::kNone;
  for (const View2::Seen& seen : view.seen) {
    if (seen.behind == kSky || !solids.is_covered(seen.behind)) return Solids2::kNone;
    first = std::min(first, solids.maker(seen.behind));
  }
  return first;
}

}  // namespace hottel

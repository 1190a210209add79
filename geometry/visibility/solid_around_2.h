// Whether a point lies in a solid, by what it sees.
#pragma once

#include <algorithm>

#include "geometry/arrangement/solids_2.h"
#include "geometry/visibility/view_2.h"

namespace hottel {

// Returns the group that makes solid what is around an eye; Solids2::kNone unless the eye lies in the interior of the
// union of all solids.
//
//   (1) exact: from there one sees covered sides only; from anywhere else, the border of a solid too, something else
//   (2) on pieces drawn inside a solid and on the common wall of two solids: one of the groups around
// COST: one look-up in the open; nothing in a scene without solids.
inline std::uint32_t solid_around(const Solids2& solids, const View2& view) {
  if (solids.is_empty() || view.seen.empty()) return Solids2::kNone;
  const auto is_free = [&](const View2::Seen& seen) { return seen.behind == kSky || !solids.is_covered(seen.behind); };
  if (std::any_of(view.seen.begin(), view.seen.end(), is_free)) return Solids2::kNone;
  return solids.maker(view.seen.front().behind);
}

}  // namespace hottel

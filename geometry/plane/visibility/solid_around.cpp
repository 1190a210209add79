#include "geometry/plane/visibility/solid_around.h"

#include <algorithm>

namespace hottel {

std::uint32_t solid_around(const Arrangement2& arrangement, const View2& view) {
  const Solids2& solids = arrangement.solids();
  if (solids.is_empty() || view.seen.empty()) return Solids2::kNone;
  std::uint32_t first = Solids2::kNone;
  for (const View2::Seen& seen : view.seen) {
    if (seen.behind == kSky || !solids.is_covered(seen.behind)) return Solids2::kNone;
    first = std::min(first, solids.maker(seen.behind));
    for (const PieceSideId beside : {seen.left, seen.right}) {
      if (beside == kNoPiece) continue;
      if (!solids.is_covered(beside)) return Solids2::kNone;
      first = std::min(first, solids.maker(beside));
    }
  }
  return first;
}

}  // namespace hottel

#include "geometry/space/visibility/seen_faces.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace hottel {

PointMap3 with_owners(PointMap3 map, const Arrangement3& arrangement) {
  const auto rename = [&arrangement](Face& face) { face = arrangement.owner(face.surface, face.is_back); };
  for (PointMap3::Fragment& fragment : map.fragments) rename(fragment.face);
  for (PointMap3::Share& share : map.shares) rename(share.face);
  std::stable_sort(map.fragments.begin(), map.fragments.end(),
                   [](const auto& a, const auto& b) { return a.face < b.face; });
  std::stable_sort(map.shares.begin(), map.shares.end(), [](const auto& a, const auto& b) { return a.face < b.face; });
  std::vector<PointMap3::Share> shares;
  for (const PointMap3::Share& share : map.shares) {
    if (shares.empty() || shares.back().face != share.face) {
      shares.push_back(share);
      continue;
    }
    shares.back().fraction += share.fraction;
    shares.back().factor += share.factor;
  }
  map.shares = std::move(shares);
  return map;
}

}  // namespace hottel

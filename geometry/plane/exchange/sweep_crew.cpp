#include "geometry/plane/exchange/sweep_crew.h"

#include <cstdint>
#include <limits>

#include "geometry/plane/exchange/exchange_sums.h"

namespace hottel {
SweptPart2 swept_part(const WorkRange& places, std::span<const VertexId> vertices, const Arrangement2& arrangement,
                      const ElementTable2& table) {
  SweptPart2 part{.begin = places.begin, .end = places.end, .counts = {}, .sums = {}};
  const PairSums2 sums =
      sum_pairs_about(vertices, arrangement, table, {}, std::numeric_limits<std::uint64_t>::max(), part.counts);
  part.sums.reserve(sums.size());
  sums.for_each([&](const PairSum2& sum) { part.sums.push_back(sum); });
  return part;
}

}  // namespace hottel

#include "geometry/plane/exchange/chosen_rows.h"

#include <algorithm>

#include "geometry/plane/exchange/convex_sums.h"
#include "geometry/plane/exchange/exchange_sums.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "kernel/support/parallel.h"

namespace hottel {

std::vector<PlainRow2> chosen_rows(const PreparedScene2& prepared, const ElementTable2& table, std::uint64_t most_pairs,
                                   const std::function<void(double)>& progress) {
  const DefaultFloatingPoint arithmetic;
  SumCounts2 counts;
  const PairSums2 sums = is_convex_room(prepared.scene)
                             ? sum_convex_pairs(prepared.arrangement, table)
                             : sum_visible_pairs(prepared.arrangement, table, progress, most_pairs, counts);
  std::vector<PlainRow2> rows(table.count());
  const auto add = [&](std::uint32_t i, std::uint32_t j, Int128 doubled) {
    if (i >= table.count() || !table.has_row(i) || doubled <= 0) return;
    rows[i].emplace_back(j, static_cast<double>(doubled) / (2 * static_cast<double>(table.length(i).value)));
  };
  sums.for_each([&](const PairSum2& pair) {
    add(pair.i(), pair.j(), pair.value);
    if (pair.i() != pair.j()) add(pair.j(), pair.i(), pair.value);
  });
  parallel_for(rows.size(), [&](std::size_t i) { std::ranges::sort(rows[i]); });
  return rows;
}

}  // namespace hottel

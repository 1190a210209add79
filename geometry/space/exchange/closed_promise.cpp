#include "geometry/space/exchange/closed_promise.h"

#include <optional>
#include <vector>

#include "geometry/closed_promise.h"
#include "geometry/space/exchange/pair_sums.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"

namespace hottel {

void require_closed(const PreparedScene3& prepared) {
  if (!prepared.scene.closed) return;
  const ElementTable3& table = *prepared.elements(Granularity::kFace);
  std::vector<char> is_now(table.count() + std::size_t{1}, 0);
  const std::vector<char> was_before = is_now;
  is_now[table.sky()] = 1;  // pairs with the sky alone
  const PairTurn3 turn{is_now, was_before};
  ExchangeReport3 report;
  const PairSums3 sums = sum_pairs(prepared, table, {.tolerance = 1, .turn = &turn}, report);
  const auto refuse_if_open = [&](std::uint32_t label) {
    if (table.has_row(label) && !table.elements()[label].is_back)
      refuse_promise(prepared.scene, table.elements()[label], std::nullopt);
  };
  // What cannot be measured is not 0.
  std::size_t failed = 0;
  for (const PairSum3& pair : sums.pairs) {
    for (; failed < sums.failures.size() && sums.failures[failed].i < pair.i; ++failed)
      refuse_if_open(sums.failures[failed].i);
    if (!pair.is_zero()) refuse_if_open(pair.i);
  }
  for (; failed < sums.failures.size(); ++failed) refuse_if_open(sums.failures[failed].i);
}

}  // namespace hottel

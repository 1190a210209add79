#include "geometry/space/exchange/narrow_by_rows.h"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/space/exchange/pair_names.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// A compensated sum of up to 2^40 numbers above 0 is right to far less than this part of itself, and what is made of it
// here with four roundings too.
constexpr double kOfSum = 0x1p-49;

}  // namespace

Enclosure RowBounds3::RowSum::rest_without(const Enclosure& one, const Enclosure& area) const {
  const double least = lower.value(), most = upper.value();
  const double roundings = kOfSum * (area.upper + most);
  return {area.lower - (most - one.upper) - roundings, area.upper - (least - one.lower) + roundings};
}

void RowBounds3::add(const RowRange& rows, std::span<const PairSum3> pairs) {
  for (const PairSum3& pair : pairs)
    for_each_row(pair, [&](std::uint32_t i) {
      if (!rows.has(i)) return;
      rows_[i].lower.add(pair.bounds.lower);
      rows_[i].upper.add(pair.bounds.upper);
    });
}

std::uint64_t RowBounds3::narrow(const RowRange& rows, std::span<PairSum3> pairs) const {
  std::uint64_t narrowed = 0;
  for (PairSum3& pair : pairs) {
    Enclosure within = pair.bounds;
    for_each_row(pair, [&](std::uint32_t i) {
      const Enclosure rest = rows_[i].rest_without(pair.bounds, table_.extent(i).enclosure());
      within = {std::max(within.lower, rest.lower), std::min(within.upper, rest.upper)};
    });
    if (!(within.lower <= within.upper))
      throw ContractViolation(fmt::format("the bounds of {} exclude what is left of a row by all others",
                                          pair_text(table_.elements(), pair.i, pair.j)));
    if (within == pair.bounds) continue;
    narrowed += rows.has(pair.i) ? 1 : 0;
    pair.bounds = within;
    pair.measure = std::clamp(pair.measure, within.lower, within.upper);
  }
  return narrowed;
}

}  // namespace hottel

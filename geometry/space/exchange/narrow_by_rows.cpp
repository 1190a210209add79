#include "geometry/space/exchange/narrow_by_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "geometry/space/exchange/pair_names.h"
#include "geometry/space/vectors/local_vector.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// A compensated sum of up to 2^40 numbers above 0 is right to far less than this part of itself, and what is made of it
// here with four roundings too.
constexpr double kOfSum = 0x1p-49;

// The bounds of all pairs of one row, summed.
struct RowSum {
  CompensatedSum<double> lower, upper;

  void add(const Enclosure& bounds) {
    lower.add(bounds.lower);
    upper.add(bounds.upper);
  }
  // What all pairs but one leave of the area.
  Enclosure rest_without(const Enclosure& one, const Enclosure& area) const {
    const double least = lower.value(), most = upper.value();
    const double roundings = kOfSum * (area.upper + most);
    return {area.lower - (most - one.upper) - roundings, area.upper - (least - one.lower) + roundings};
  }
};

}  // namespace

std::uint64_t narrow_by_rows(const ElementTable3& table, std::span<PairSum3> pairs) {
  const auto for_each_row = [&](const PairSum3& pair, const auto& visit) {
    if (table.has_row(pair.i)) visit(pair.i);
    if (pair.j != pair.i && pair.j != table.sky() && table.has_row(pair.j)) visit(pair.j);
  };
  std::vector<RowSum> rows(table.count());
  for (const PairSum3& pair : pairs) for_each_row(pair, [&](std::uint32_t i) { rows[i].add(pair.bounds); });
  std::uint64_t narrowed = 0;
  for (PairSum3& pair : pairs) {
    Enclosure within = pair.bounds;
    for_each_row(pair, [&](std::uint32_t i) {
      const Enclosure rest = rows[i].rest_without(pair.bounds, table.extent(i).enclosure());
      within = {std::max(within.lower, rest.lower), std::min(within.upper, rest.upper)};
    });
    if (!(within.lower <= within.upper))
      throw ContractViolation(fmt::format("the bounds of {} exclude what is left of a row by all others",
                                          pair_text(table.elements(), pair.i, pair.j)));
    if (within == pair.bounds) continue;
    ++narrowed;
    pair.bounds = within;
    pair.measure = std::clamp(pair.measure, within.lower, within.upper);
  }
  return narrowed;
}

}  // namespace hottel

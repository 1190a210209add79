#include "geometry/plane/exchange/pair_rounding.h"

#include "geometry/unit_of_length.h"
#include "geometry/visibility_quotient.h"

namespace hottel {
namespace {

// Half a unit of integer form, in metres.
Rational half_unit_in_metres(const PreparedScene2& prepared) {
  return prepared.arrangement.vertices().scale() * metres_per_unit(prepared.scene) / 2;
}

}  // namespace

PairRounding2::PairRounding2(const PreparedScene2& prepared, const ElementTable2& table, const ExchangeRequest& request)
    : prepared_(prepared),
      table_(table),
      request_(request),
      alone_(prepared, table, request.granularity),
      half_unit_(prepared.arrangement.vertices().fixed_unit() * half_unit_in_metres(prepared)) {
  for (std::uint32_t label = 0; label < table.count(); ++label) {
    const FixedSum& length = table.length(label);
    double_length_.push_back(table.has_row(label) ? FixedDivisor({2 * length.value, 2 * length.error})
                                                  : FixedDivisor());
  }
}

RoundedPair2 PairRounding2::quick(const PairSum2& pair, const RowRange& rows, TierCounts& tiers) const {
  const Vertices2& vertices = prepared_.arrangement.vertices();
  const FixedDividend sum(pair.sum(vertices.length_error()));
  RoundedPair2 result;
  // A sum that may be zero is looked at exactly before anything is printed of it.
  const bool may_be_zero = sum.may_be_zero();
  const std::uint32_t i = pair.i(), j = pair.j();
  const bool counts = rows.has(table_.has_row(i) ? i : j);
  const auto settle = [&](const FixedDivisor& divisor, Rounded& number, bool& is_open, bool is_counted) {
    const auto rounded = may_be_zero || !divisor.is_usable() ? std::nullopt : round_quotient(sum, divisor);
    is_open = !rounded;
    if (!rounded) return;
    number = rounded->number;
    if (is_counted) tiers.count(rounded->tier);
  };
  if (table_.has_row(i) && rows.has(i)) settle(double_length_[i], result.forth, result.is_forth_open, true);
  if (table_.has_row(j) && rows.has(j)) settle(double_length_[j], result.back, result.is_back_open, true);
  if (request_.wants_measures) {
    const auto rounded = may_be_zero ? std::nullopt : round_scaled(sum, half_unit_);
    result.is_measure_open = !rounded;
    if (rounded) result.measure = rounded->number.value;
  }
  if (!request_.wants_visibility || j == table_.sky()) return result;
  if (!alone_.are_straight(i, j)) {
    result.is_visibility_open = true;
  } else if (!pair.is_obstructed && !may_be_zero) {
    result.visibility = 1;
    if (counts) tiers.count(Tier::kDouble);
  } else {
    Rounded visibility;
    const auto free = alone_.quick(i, j);
    settle(free ? FixedDivisor(*free) : FixedDivisor(), visibility, result.is_visibility_open, counts);
    result.visibility = visibility_of(visibility);
  }
  return result;
}

// Settles what quick() left open.
void PairRounding2::exactly(const PairSum2& pair, const RootSum& sum, RoundedPair2& result, TierCounts& tiers) const {
  const Vertices2& vertices = prepared_.arrangement.vertices();
  if (sum.is_zero()) {
    result = {};
    result.is_zero = true;
    return;
  }
  const auto settle = [&](std::uint32_t label) {
    const RoundedByTier rounded = round_quotient(sum, table_.exact_length(label, vertices) * Rational(2));
    tiers.count(rounded.tier);
    return rounded.number;
  };
  if (result.is_forth_open) result.forth = settle(pair.i());
  if (result.is_back_open) result.back = settle(pair.j());
  if (result.is_measure_open)
    result.measure = round_quotient(sum * half_unit_in_metres(prepared_), RootSum(Rational(1))).number.value;
  if (!result.is_visibility_open) return;
  const RootSum free = alone_.exact(pair.i(), pair.j()) * (Rational(2) / vertices.scale());
  if ((free - sum).is_zero()) {
    result.visibility = 1;
    tiers.count(Tier::kRootSum);
  } else {
    const RoundedByTier rounded = round_quotient(sum, free);
    tiers.count(rounded.tier);
    result.visibility = visibility_of(rounded.number);
  }
}

}  // namespace hottel

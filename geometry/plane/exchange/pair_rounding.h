// From the sum of one pair to what is printed of it.
#pragma once

#include <limits>
#include <vector>

#include "geometry/exchange_request.h"
#include "geometry/plane/exchange/exchange_sums.h"
#include "geometry/plane/exchange/pair_alone.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/row_ranges.h"
#include "kernel/rounding.h"

namespace hottel {

// What is printed of one pair, and what the fixed-point sums could not settle.
struct RoundedPair2 {
  Rounded forth, back;  // F(i, j), F(j, i); unset where there is no row
  double visibility = std::numeric_limits<double>::quiet_NaN();
  double measure = std::numeric_limits<double>::quiet_NaN();
  bool is_forth_open = false, is_back_open = false, is_visibility_open = false, is_measure_open = false,
       is_zero = false;

  bool is_open() const { return is_forth_open || is_back_open || is_visibility_open || is_measure_open; }
  // An element that sees one thing only sees it with factor 1, by closure: no arithmetic is needed to know it. is_...:
  // whether the row of i, of j, has no other pair.
  void settle_by_closure(bool is_only_of_i, bool is_only_of_j) {
    const auto settle = [](Rounded& factor, bool& is_factor_open) {
      if (is_factor_open) factor = {1.0, 0};
      is_factor_open = false;
    };
    if (is_only_of_i) settle(forth, is_forth_open);
    if (is_only_of_j) settle(back, is_back_open);
  }
};

// Rounds pair sums correctly: by fixed point where that settles it, else from the exact sum.
//
//   (1) quick() leaves open what its error bounds do not settle; exactly() settles all of that
//   (2) a sum that may be zero is left open altogether: whether the pair exists is decided exactly
class PairRounding2 {
 public:
  // REQUIRES that all three outlive this.
  PairRounding2(const PreparedScene2& prepared, const ElementTable2& table, const ExchangeRequest& request);

  // What fixed point settles of the pair. Counts a tier for each factor and visibility that it settles.
  //
  //   (1) an unobstructed pair of straight elements has visibility 1, unless its sum may be zero
  //   (2) the sky has no visibility: it stays NaN
  RoundedPair2 quick(const PairSum2& pair, TierCounts& tiers) const { return quick(pair, RowRange::all(), tiers); }
  // The same of F(i, j) and F(j, i) in some rows alone; the visibility counts where the first of the two that have a
  // row has it in these.
  RoundedPair2 quick(const PairSum2& pair, const RowRange& rows, TierCounts& tiers) const;
  // Settles what quick() left open in `result`, and nothing else; of a sum that is zero it says is_zero alone.
  // REQUIRES: sum is 2 S(i, j) in integer form.
  void exactly(const PairSum2& pair, const RootSum& sum, RoundedPair2& result, TierCounts& tiers) const;

 private:
  const PreparedScene2& prepared_;
  const ElementTable2& table_;
  const ExchangeRequest& request_;
  const PairsAlone2 alone_;
  std::vector<FixedDivisor> double_length_;  // by label
  const FixedScale half_unit_;               // 2 S in fixed point to S in scene units
};

}  // namespace hottel

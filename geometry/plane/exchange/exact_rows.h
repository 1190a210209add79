// Exact view factors of a scene in the plane, row by row.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "geometry/exchange_report.h"
#include "geometry/exchange_request.h"
#include "geometry/plane/exchange/pair_rounding.h"
#include "geometry/plane/exchange/sum_source.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/row_ranges.h"

namespace hottel {

// What a sum takes in memory at the most while rows are made of sums, in bytes. Measured on clutter with backs.
inline constexpr std::uint64_t kBytesPerSum2 = 120;

// The elements of a scene, with the rows that are asked for alone.
std::shared_ptr<const ElementTable2> table_with_rows(const PreparedScene2& prepared, const ExchangeRequest& request);

// The rows of exact_exchange(), a range at a time, from sums that may be anywhere.
//
//   (1) factors, sides and visibilities are those of exact_exchange(), bit for bit, however rows are cut into ranges
//   (2) the closure of every row is looked at before any is loaded: ContractViolation where a sum is missing, there
//       twice, or another one
// Measures are not made. COST: all pairs are rounded twice, once to know where rows begin; the memory of one range, and
// of the pairs that fixed point does not settle.
class ExactRows2 final : public RowRanges {
 public:
  // REQUIRES: the sums of table_with_rows(prepared, request); all outlive this.
  ExactRows2(const PreparedScene2& prepared, const ElementTable2& table, const ExchangeRequest& request,
             const SumSource2& sums, ExchangeReport& report);

  std::size_t count() const override { return sums_.cuts().count(); }
  std::span<const std::size_t> begins() const override { return begins_; }
  const ExchangeMatrix& matrix() const override { return matrix_; }
  RowRange load(std::size_t k) override;

 private:
  struct Open {
    PairSum2 sum;
    RoundedPair2 rounded;
  };
  class Range;

  void count_entries(ExchangeReport& report);
  void require_closed_rows(const Range& range) const;
  void settle(ExchangeReport& report);
  const RoundedPair2& settled(std::uint64_t key) const;

  const PreparedScene2& prepared_;
  const ElementTable2& table_;
  const SumSource2& sums_;
  const PairRounding2 rounding_;
  std::vector<std::size_t> begins_;
  std::vector<Open> open_;  // by key; settled once and for all
  ExchangeMatrix matrix_;
};

}  // namespace hottel

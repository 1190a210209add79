#include "geometry/plane/exchange/exact_rows.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include "geometry/plane/exchange/exact_sums.h"
#include "geometry/plane/prepared/element_table.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "kernel/support/stopwatch.h"

namespace hottel {

std::shared_ptr<const ElementTable2> table_with_rows(const PreparedScene2& prepared, const ExchangeRequest& request) {
  std::shared_ptr<const ElementTable2> all = prepared.elements(request.granularity);
  if (request.rows.is_all()) return all;
  ElementTable2 table = *all;
  std::vector<bool> is_chosen(table.count());
  for (const std::uint32_t label : request.rows.labels(table.elements())) is_chosen[label] = true;
  table.keep_rows(is_chosen);
  return std::make_shared<const ElementTable2>(std::move(table));
}

// The sums of a range, with the places of their entries among those of its rows.
class ExactRows2::Range {
 public:
  Range(const ExactRows2& rows, std::size_t k)
      : table_(rows.table_), rows_(rows.sums_.cuts().range(k)), sums_(rows.sums_.sums(k)) {
    begin_.assign(rows_.end - rows_.first + std::size_t{1}, 0);
    for (const PairSum2& sum : sums_)
      for_each_row(sum, [this](std::uint32_t row, std::uint32_t) { ++begin_[row - rows_.first + 1]; });
    for (std::size_t row = 1; row < begin_.size(); ++row) begin_[row] += begin_[row - 1];
  }

  const RowRange& rows() const { return rows_; }
  const std::vector<PairSum2>& sums() const { return sums_; }
  std::size_t size_of(std::uint32_t row) const { return begin_[row - rows_.first + 1] - begin_[row - rows_.first]; }
  std::size_t begin_of(std::uint32_t row) const { return begin_[row - rows_.first]; }
  std::size_t entries() const { return begin_.back(); }

  // Calls visit(row, column) for the entries of a pair that stand in the range.
  template <class Visit>
  void for_each_row(const PairSum2& sum, const Visit& visit) const {
    const std::uint32_t i = sum.i(), j = sum.j();
    if (rows_.has(i) && table_.has_row(i)) visit(i, j);
    if (j != i && rows_.has(j) && table_.has_row(j)) visit(j, i);
  }
  // Whether it is the range to count the pair in, of the two that may have it.
  bool counts(const PairSum2& sum) const { return rows_.has(table_.has_row(sum.i()) ? sum.i() : sum.j()); }

  RoundedPair2 rounded(const PairSum2& sum, const PairRounding2& rounding, TierCounts& tiers) const {
    RoundedPair2 result = rounding.quick(sum, rows_, tiers);
    if (!result.is_open()) return result;
    const auto is_lonely = [this](std::uint32_t row) {
      return rows_.has(row) && row < table_.count() && size_of(row) == 1;
    };
    result.settle_by_closure(is_lonely(sum.i()), is_lonely(sum.j()));
    return result;
  }

 private:
  const ElementTable2& table_;
  RowRange rows_;
  std::vector<PairSum2> sums_;
  std::vector<std::size_t> begin_;  // of each row, and the number of all entries
};

ExactRows2::ExactRows2(const PreparedScene2& prepared, const ElementTable2& table, const ExchangeRequest& request,
                       const SumSource2& sums, ExchangeReport& report)
    : prepared_(prepared),
      table_(table),
      sums_(sums),
      rounding_(prepared, table, request),
      begins_(table.count() + std::size_t{1}, 0),
      matrix_(table.elements(), Guarantee::kExact) {
  const DefaultFloatingPoint arithmetic;
  HOTTEL_REQUIRE(!request.wants_measures);
  Stopwatch watch;
  count_entries(report);
  report.seconds["round"] = watch.lap();
  if (!open_.empty()) {
    settle(report);
    report.seconds["exact"] = watch.lap();
  }
  for (std::size_t row = 1; row < begins_.size(); ++row) begins_[row] += begins_[row - 1];
}

// How many entries each row has, those that may be zero among them, and which pairs are open.
void ExactRows2::count_entries(ExchangeReport& report) {
  std::mutex together;
  for (std::size_t k = 0; k < count(); ++k) {
    const Range range(*this, k);
    require_closed_rows(range);
    for (std::uint32_t row = range.rows().first; row < range.rows().end; ++row)
      begins_[row + std::size_t{1}] = range.size_of(row);
    parallel_ranges(range.sums().size(), 256, [&](std::size_t begin, std::size_t end) {
      TierCounts tiers;
      std::vector<Open> open;
      std::uint64_t pairs = 0;
      for (std::size_t n = begin; n < end; ++n) {
        const PairSum2& sum = range.sums()[n];
        pairs += range.counts(sum) ? 1 : 0;
        if (range.rounded(sum, rounding_, tiers).is_open()) open.push_back({sum, {}});
      }
      const std::lock_guard lock(together);
      report.tiers += tiers;
      report.pairs += pairs;
      open_.insert(open_.end(), open.begin(), open.end());
    });
  }
  report.closure_is_exact = true;
}

// As closure_defect() of all sums.
void ExactRows2::require_closed_rows(const Range& range) const {
  std::vector<Int128> sum(range.rows().end - range.rows().first, 0);
  for (const PairSum2& pair : range.sums())
    range.for_each_row(pair, [&](std::uint32_t row, std::uint32_t) { sum[row - range.rows().first] += pair.value; });
  for (std::uint32_t row = range.rows().first; row < range.rows().end; ++row)
    HOTTEL_REQUIRE(!table_.has_row(row) || sum[row - range.rows().first] == 2 * table_.length(row).value);
}

// Settles what is open by exact sums, and takes the pairs that exchange nothing out of their rows.
void ExactRows2::settle(ExchangeReport& report) {
  const auto key = [](const Open& open) { return open.sum.key; };
  std::ranges::sort(open_, {}, key);
  const auto is_same = [](const Open& a, const Open& b) { return a.sum.key == b.sum.key; };
  open_.erase(std::unique(open_.begin(), open_.end(), is_same), open_.end());
  std::vector<ElementPair> pairs;
  for (const Open& open : open_) pairs.emplace_back(open.sum.i(), open.sum.j());
  const std::vector<RootSum> sums = exact_sums(prepared_.arrangement, table_, pairs);
  std::mutex together;
  parallel_for(open_.size(), [&](std::size_t n) {
    TierCounts counted, some;  // what is settled quickly was counted
    const PairSum2& sum = open_[n].sum;
    RoundedPair2& rounded = open_[n].rounded = rounding_.quick(sum, counted);
    const auto is_lonely = [this](std::uint32_t row) {
      return row < table_.count() && begins_[row + std::size_t{1}] == 1;
    };
    rounded.settle_by_closure(is_lonely(sum.i()), is_lonely(sum.j()));
    rounding_.exactly(sum, sums[n], rounded, some);
    const std::lock_guard lock(together);
    report.tiers += some;
  });
  for (const Open& open : open_) {
    if (!open.rounded.is_zero) continue;
    --report.pairs;
    const std::uint32_t i = open.sum.i(), j = open.sum.j();
    if (table_.has_row(i)) --begins_[i + std::size_t{1}];
    if (j != i && table_.has_row(j)) --begins_[j + std::size_t{1}];
  }
}

const RoundedPair2& ExactRows2::settled(std::uint64_t key) const {
  return std::ranges::lower_bound(open_, key, {}, [](const Open& open) { return open.sum.key; })->rounded;
}

RowRange ExactRows2::load(std::size_t k) {
  const DefaultFloatingPoint arithmetic;
  const Range range(*this, k);
  // Entries of a row ascend by column, as the sums do by key.
  std::vector<std::size_t> next;
  for (std::uint32_t row = range.rows().first; row < range.rows().end; ++row) next.push_back(begins_[row]);
  const std::size_t first = range.rows().first == range.rows().end ? 0 : begins_[range.rows().first];
  FactorEntries entries(begins_[range.rows().end] - first);
  std::vector<std::pair<std::size_t, std::size_t>> places(range.sums().size());
  const auto is_zero = [this](const PairSum2& sum) {
    const auto open = std::ranges::lower_bound(open_, sum.key, {}, [](const Open& o) { return o.sum.key; });
    return open != open_.end() && open->sum.key == sum.key && open->rounded.is_zero;
  };
  for (std::size_t n = 0; n < places.size(); ++n) {
    const PairSum2& sum = range.sums()[n];
    if (!open_.empty() && is_zero(sum)) continue;
    range.for_each_row(sum, [&](std::uint32_t row, std::uint32_t) {
      (row == sum.i() ? places[n].first : places[n].second) = next[row - range.rows().first]++ - first;
    });
  }
  parallel_for(
      places.size(),
      [&](std::size_t n) {
        const PairSum2& sum = range.sums()[n];
        TierCounts counted;
        RoundedPair2 rounded = range.rounded(sum, rounding_, counted);
        if (rounded.is_open()) rounded = settled(sum.key);
        if (rounded.is_zero) return;
        range.for_each_row(sum, [&](std::uint32_t row, std::uint32_t to) {
          const Rounded& factor = row == sum.i() ? rounded.forth : rounded.back;
          entries.set(row == sum.i() ? places[n].first : places[n].second,
                      {to, factor, to == table_.sky() ? factor.value : rounded.visibility});
        });
      },
      256);
  std::vector<std::size_t> begin(begins_.size(), 0);
  for (std::size_t row = 0; row < begin.size(); ++row)
    begin[row] = std::clamp(begins_[row], first, first + entries.size()) - first;
  matrix_.assign(std::move(begin), std::move(entries));
  return range.rows();
}

}  // namespace hottel

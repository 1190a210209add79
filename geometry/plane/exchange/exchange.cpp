#include "geometry/plane/exchange/exchange.h"

#include <algorithm>
#include <limits>
#include <mutex>

#include "geometry/plane/exchange/exact_rows.h"
#include "geometry/plane/exchange/exact_sums.h"
#include "geometry/plane/exchange/exchange_sums.h"
#include "geometry/plane/exchange/pair_alone.h"
#include "geometry/plane/exchange/pair_rounding.h"
#include "geometry/plane/exchange/pair_sums.h"
#include "geometry/plane/exchange/requested_sums.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "kernel/support/stopwatch.h"

namespace hottel {
namespace {

// The entries of a matrix, each put straight where it stays. Different pairs may be put at the same time.
class Entries {
 public:
  Entries(const PairSums2& sums, const ElementTable2& table, bool with_measures)
      : table_(table),
        places_(sums, table),
        entries_(places_.begin().back()),
        measures_(with_measures ? entries_.size() : 0) {}

  const EntryPlaces2& places() const { return places_; }

  // REQUIRES: `sum` is the k-th of all.
  void put(std::size_t k, const PairSum2& sum, const RoundedPair2& rounded) {
    const std::uint32_t i = sum.i(), j = sum.j();
    const auto put_entry = [&](std::size_t place, std::uint32_t to, const Rounded& factor) {
      entries_.set(place,
                   {rounded.is_zero ? kNowhere : to, factor, to == table_.sky() ? factor.value : rounded.visibility});
      if (!measures_.empty()) measures_[place] = rounded.measure;
    };
    if (table_.has_row(i)) put_entry(places_.forth(i, k), j, rounded.forth);
    if (j != i && table_.has_row(j)) put_entry(places_.back(j, k), i, rounded.back);
  }

  // The matrix of what was put, without what is zero. REQUIRES: every pair was put; nothing is asked of this
  // afterwards.
  ExchangeMatrix take(bool has_zeros) {
    std::vector<std::size_t> begin = places_.begin();
    if (has_zeros) remove_zeros(begin);
    ExchangeMatrix matrix(table_.elements(), Guarantee::kExact);
    matrix.assign(std::move(begin), std::move(entries_), std::move(measures_));
    return matrix;
  }

 private:
  static constexpr std::uint32_t kNowhere = std::numeric_limits<std::uint32_t>::max();

  void remove_zeros(std::vector<std::size_t>& begin) {
    std::size_t kept = 0;
    for (std::size_t row = 0, place = 0; row + 1 < begin.size(); ++row) {
      const std::size_t end = begin[row + 1];
      for (; place < end; ++place) {
        if (entries_[place].to == kNowhere) continue;
        entries_.set(kept, entries_[place]);
        if (!measures_.empty()) measures_[kept] = measures_[place];
        ++kept;
      }
      begin[row + 1] = kept;
    }
    entries_.resize(kept);
    if (!measures_.empty()) measures_.resize(kept);
  }

  const ElementTable2& table_;
  const EntryPlaces2 places_;
  FactorEntries entries_;
  std::vector<double> measures_;
};

// The elements in whose rows sums stand, those that lie near each other one after another: what they ask of their
// partners is in the cache then.
std::vector<std::uint32_t> labels_by_place(const PairSums2& sums, const ElementTable2& table,
                                           const Arrangement2& arrangement) {
  std::vector<std::uint32_t> rank(arrangement.vertices().size());
  std::uint32_t next = 0;
  for (const VertexId v : arrangement.triangulation().sweep_order()) rank[v.index()] = next++;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> placed;
  placed.reserve(table.count());
  for (std::uint32_t label = 0; label < table.count(); ++label)
    if (!sums.row(label).empty())
      placed.emplace_back(table.runs(label).empty() ? next : rank[table.runs(label).front().a.index()], label);
  std::ranges::sort(placed);
  std::vector<std::uint32_t> labels;
  labels.reserve(placed.size());
  for (const auto& [place, label] : placed) labels.push_back(label);
  return labels;
}

// A pair that fixed point does not settle.
struct OpenPair {
  std::size_t k;  // of all pairs
  PairSum2 sum;
  RoundedPair2 rounded;
};

// Settles what closure alone tells.
void settle_lonely_rows(OpenPair& pair, const EntryPlaces2& places, const ElementTable2& table) {
  const auto is_lonely = [&](std::uint32_t label) { return label != table.sky() && places.row_size(label) == 1; };
  pair.rounded.settle_by_closure(is_lonely(pair.sum.i()), is_lonely(pair.sum.j()));
}

// Settles what is open by exact sums, and puts it anew. Returns how many pairs exchange nothing.
std::size_t put_exactly(std::vector<OpenPair>& open, const PreparedScene2& prepared, const ElementTable2& table,
                        const PairRounding2& rounding, Entries& entries, TierCounts& tiers) {
  std::ranges::sort(open, {}, &OpenPair::k);
  std::vector<ElementPair> pairs;
  for (const OpenPair& pair : open) pairs.emplace_back(pair.sum.i(), pair.sum.j());
  const std::vector<RootSum> sums = exact_sums(prepared.arrangement, table, pairs);
  std::mutex together;
  parallel_for(open.size(), [&](std::size_t n) {
    TierCounts some;
    rounding.exactly(open[n].sum, sums[n], open[n].rounded, some);
    entries.put(open[n].k, open[n].sum, open[n].rounded);
    const std::lock_guard lock(together);
    tiers += some;
  });
  return static_cast<std::size_t>(std::ranges::count_if(open, [](const auto& pair) { return pair.rounded.is_zero; }));
}

}  // namespace

ExchangeMatrix exact_exchange(const PreparedScene2& prepared, const ExchangeRequest& request, ExchangeReport* report,
                              SweepParts2* parts) {
  const DefaultFloatingPoint arithmetic;
  Stopwatch watch;
  ExchangeReport ignored;
  ExchangeReport& r = report != nullptr ? *report : ignored;
  const Arrangement2& arrangement = prepared.arrangement;
  const std::shared_ptr<const ElementTable2> with_rows = table_with_rows(prepared, request);
  const ElementTable2& table = *with_rows;
  r.seconds["prepare"] = prepared.seconds;
  r.seconds["label"] = watch.lap();

  const PairSums2 sums = requested_sums(prepared, table, request, kBytesPerPair, r, parts);
  watch.lap();
  r.closure_is_exact = closure_defect(sums, table) == 0;
  HOTTEL_REQUIRE(r.closure_is_exact);

  const PairRounding2 rounding(prepared, table, request);
  Entries entries(sums, table, request.wants_measures);
  std::vector<OpenPair> open;
  std::mutex together;
  const std::vector<std::uint32_t> labels = labels_by_place(sums, table, arrangement);
  parallel_ranges(labels.size(), 16, [&](std::size_t begin, std::size_t end) {
    TierCounts some;
    std::vector<OpenPair> left;
    for (std::size_t n = begin; n < end; ++n) {
      std::size_t k = sums.before(labels[n]);
      for (const PairSum2& sum : sums.row(labels[n])) {
        OpenPair pair{k++, sum, rounding.quick(sum, some)};
        if (pair.rounded.is_open()) settle_lonely_rows(pair, entries.places(), table);
        entries.put(pair.k, sum, pair.rounded);
        if (pair.rounded.is_open()) left.push_back(pair);
      }
    }
    const std::lock_guard lock(together);
    r.tiers += some;
    open.insert(open.end(), left.begin(), left.end());
  });
  r.seconds["round"] = watch.lap();

  std::size_t zeros = 0;
  if (!open.empty()) {
    zeros = put_exactly(open, prepared, table, rounding, entries, r.tiers);
    r.seconds["exact"] = watch.lap();
  }

  report_scene(prepared, table, r);
  r.pairs = sums.size() - zeros;
  ExchangeMatrix matrix = entries.take(zeros > 0);
  r.seconds["matrix"] = watch.lap();
  return matrix;
}

std::vector<ElementPair> hidden_pairs(const PreparedScene2& prepared, Granularity granularity,
                                      const ExchangeMatrix& matrix, const RowChoice& chosen) {
  const ElementTable2& table = *prepared.elements(granularity);
  const PairsAlone2 alone(prepared, table, granularity);
  std::vector<ElementPair> result;
  for (std::uint32_t i = 0; i < table.count(); ++i) {
    if (!matrix.has_row(i) || !chosen.has(matrix.elements()[i])) continue;
    const auto row = matrix.row(i);
    auto entry = row.begin();
    for (std::uint32_t j = 0; j < table.count(); ++j) {
      while (entry != row.end() && entry->to < j) ++entry;
      if (entry != row.end() && entry->to == j) continue;
      if (alone.is_positive(i, j)) result.emplace_back(i, j);
    }
    if (row.empty() || row.back().to != table.sky()) result.emplace_back(i, table.sky());
  }
  return result;
}

}  // namespace hottel

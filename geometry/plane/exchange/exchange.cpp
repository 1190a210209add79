#include "geometry/plane/exchange/exchange.h"

#include <algorithm>
#include <limits>
#include <mutex>

#include "geometry/plane/exchange/convex_sums.h"
#include "geometry/plane/exchange/exact_sums.h"
#include "geometry/plane/exchange/exchange_sums.h"
#include "geometry/plane/exchange/pair_alone.h"
#include "geometry/plane/exchange/pair_rounding.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "kernel/support/stopwatch.h"

namespace hottel {
namespace {

std::uint64_t count_all_pairs(const ElementTable2& table) {
  std::uint64_t rows = 0;
  for (std::uint32_t i = 0; i < table.count(); ++i) rows += table.has_row(i);
  return rows * (rows - 1) / 2;
}

ExchangeMatrix to_matrix(const ElementTable2& table, const std::vector<PairSum2>& pairs,
                         const std::vector<RoundedPair2>& rounded, bool with_measures) {
  ExchangeMatrix matrix(table.elements(), Guarantee::kExact);
  std::vector<std::size_t> begin(table.count() + 1, 0);
  const auto each_entry = [&](const auto& visit) {
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      if (rounded[k].is_zero) continue;
      const auto [i, j] = std::pair(pairs[k].i, pairs[k].j);
      if (table.has_row(i)) visit(i, j, rounded[k].forth, rounded[k]);
      if (j != i && table.has_row(j)) visit(j, i, rounded[k].back, rounded[k]);
    }
  };
  each_entry([&](std::uint32_t from, std::uint32_t, const Rounded&, const RoundedPair2&) { ++begin[from + 1]; });
  for (std::uint32_t i = 0; i < table.count(); ++i) begin[i + 1] += begin[i];
  std::vector<FactorEntry> entries(begin.back());
  std::vector<double> measures(with_measures ? begin.back() : 0);
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  each_entry([&](std::uint32_t from, std::uint32_t to, const Rounded& factor, const RoundedPair2& pair) {
    const std::size_t place = next[from]++;
    entries[place] = {to, factor, to == table.sky() ? factor.value : pair.visibility};
    if (with_measures) measures[place] = pair.measure;
  });
  matrix.assign(std::move(begin), std::move(entries), std::move(measures));
  return matrix;
}

// The pairs of each smaller label, [begin, end), labels that lie near each other one after another: what they ask of
// their partners is in the cache then. REQUIRES pairs in order.
std::vector<std::pair<std::size_t, std::size_t>> rows_by_place(const std::vector<PairSum2>& pairs,
                                                               const ElementTable2& table,
                                                               const Arrangement2& arrangement) {
  std::vector<std::uint32_t> rank(arrangement.vertices().size());
  std::uint32_t next = 0;
  for (const VertexId v : arrangement.triangulation().sweep_order()) rank[v.index()] = next++;
  struct Row {
    std::uint32_t place;
    std::size_t begin, end;
  };
  std::vector<Row> placed;
  for (std::size_t begin = 0, end = 0; begin < pairs.size(); begin = end) {
    const std::uint32_t label = pairs[begin].i;
    while (end < pairs.size() && pairs[end].i == label) ++end;
    const bool is_nowhere = label >= table.count() || table.runs(label).empty();
    placed.push_back({is_nowhere ? next : rank[table.runs(label).front().a.index()], begin, end});
  }
  std::ranges::sort(placed, {}, [](const Row& row) { return std::pair(row.place, row.begin); });
  std::vector<std::pair<std::size_t, std::size_t>> rows;
  rows.reserve(placed.size());
  for (const Row& row : placed) rows.emplace_back(row.begin, row.end);
  return rows;
}

}  // namespace

ExchangeMatrix exact_exchange(const PreparedScene2& prepared, const ExchangeRequest& request, ExchangeReport* report) {
  const DefaultFloatingPoint arithmetic;
  Stopwatch watch;
  ExchangeReport ignored;
  ExchangeReport& r = report != nullptr ? *report : ignored;
  const Arrangement2& arrangement = prepared.arrangement;
  const ElementTable2 table(prepared.scene, arrangement, prepared.division, request.granularity);
  r.seconds["prepare"] = prepared.seconds;
  r.seconds["label"] = watch.lap();

  const bool sweeps = request.always_sweeps || !is_convex_room(prepared.scene);
  std::uint64_t most_pairs = std::numeric_limits<std::uint64_t>::max();
  if (request.memory > 0) {
    most_pairs = request.memory / kBytesPerPair;
    const std::uint64_t pairs = sweeps ? estimated_sight(arrangement, table).pairs : count_all_pairs(table);
    if (pairs > most_pairs)
      throw RequestError("about " + std::to_string(pairs) + " visible pairs need about " +
                         std::to_string(pairs * kBytesPerPair) + " bytes; allowed are " +
                         std::to_string(request.memory));
  }
  SumCounts2 counts;
  const std::vector<PairSum2> pairs = sweeps
                                          ? sum_visible_pairs(arrangement, table, request.progress, most_pairs, counts)
                                          : sum_convex_pairs(arrangement, table);
  r.seconds[sweeps ? "sweep" : "strings"] = watch.lap();
  r.closure_is_exact = closure_defect(pairs, table) == 0;
  HOTTEL_REQUIRE(r.closure_is_exact);

  const PairRounding2 rounding(prepared, table, request);
  std::vector<RoundedPair2> rounded(pairs.size());
  std::mutex tiers;
  const auto count = [&r, &tiers](const TierCounts& some) {
    const std::lock_guard lock(tiers);
    r.tiers += some;
  };
  const auto rows = rows_by_place(pairs, table, arrangement);
  parallel_ranges(rows.size(), 16, [&](std::size_t begin, std::size_t end) {
    TierCounts some;
    for (std::size_t row = begin; row < end; ++row)
      for (std::size_t k = rows[row].first; k < rows[row].second; ++k) rounded[k] = rounding.quick(pairs[k], some);
    count(some);
  });
  settle_lonely_rows(pairs, table, rounded);
  r.seconds["round"] = watch.lap();

  std::vector<std::size_t> open;
  std::vector<ElementPair> open_pairs;
  for (std::size_t k = 0; k < pairs.size(); ++k)
    if (rounded[k].is_open()) {
      open.push_back(k);
      open_pairs.emplace_back(pairs[k].i, pairs[k].j);
    }
  if (!open.empty()) {
    const std::vector<RootSum> sums = exact_sums(arrangement, table, open_pairs);
    parallel_for(open.size(), [&](std::size_t k) {
      TierCounts some;
      rounding.exactly(pairs[open[k]], sums[k], rounded[open[k]], some);
      count(some);
    });
    r.seconds["exact"] = watch.lap();
  }

  r.surfaces = prepared.scene.surfaces.size();
  r.vertices = arrangement.vertices().size();
  r.pieces = arrangement.pieces().size();
  r.elements = table.count();
  r.pairs = static_cast<std::uint64_t>(
      std::count_if(rounded.begin(), rounded.end(), [](const auto& pair) { return !pair.is_zero; }));
  r.gaps = counts.gaps;
  r.terms = counts.updates;
  ExchangeMatrix matrix = to_matrix(table, pairs, rounded, request.wants_measures);
  r.seconds["matrix"] = watch.lap();
  return matrix;
}

std::vector<ElementPair> hidden_pairs(const PreparedScene2& prepared, Granularity granularity,
                                      const ExchangeMatrix& matrix) {
  const ElementTable2 table(prepared.scene, prepared.arrangement, prepared.division, granularity);
  const PairsAlone2 alone(prepared, table, granularity);
  std::vector<ElementPair> result;
  for (std::uint32_t i = 0; i < table.count(); ++i) {
    if (!matrix.has_row(i)) continue;
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

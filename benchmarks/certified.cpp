// What the guarantee costs: exact_exchange against sums of plain doubles over the same gaps.
//
// The plain version is written here as one would write it without any promise: the same views and gaps, lengths by
// sqrt, one hash table of doubles (that of exact_exchange), one division for each factor. Nothing says how far off it
// is. Both run on one thread, without visibilities, on the same prepared scene, one after the other in each iteration.
// The time reported is that of exact_exchange; `ratio` is that time over the plain one's; `max_error` is the largest
// difference of a plain factor from the correctly rounded one, `false_pairs` the pairs that the plain sums show and
// that do not exchange anything.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "benchmarks/clutter.h"
#include "geometry/exchange_request.h"
#include "geometry/pair_table.h"
#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/exchange/gap_terms.h"
#include "geometry/plane/exchange/term_sums.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "kernel/support/parallel.h"

namespace hottel::benchmarks {
namespace {

struct PlainEntry {
  std::uint32_t to;
  double factor;
};

struct PlainMatrix {
  std::vector<std::size_t> begin;
  std::vector<PlainEntry> entries;

  double factor(std::uint32_t from, std::uint32_t to) const {
    const auto first = entries.begin() + static_cast<std::ptrdiff_t>(begin[from]);
    const auto last = entries.begin() + static_cast<std::ptrdiff_t>(begin[from + 1]);
    const auto place = std::lower_bound(first, last, to, [](const PlainEntry& e, std::uint32_t j) { return e.to < j; });
    return place != last && place->to == to ? place->factor : 0;
  }
};

PlainMatrix plain_exchange(const PreparedScene2& prepared) {
  const Arrangement2& arrangement = prepared.arrangement;
  const ElementTable2& elements = *prepared.elements(Granularity::kFace);
  const Vertices2& vertices = arrangement.vertices();
  const auto distance = [&vertices](VertexId v, VertexId w) {
    const auto &p = vertices.approximate(v), &q = vertices.approximate(w);
    return std::sqrt((q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y));
  };

  PairTable<PlainTerm2> pairs;
  View2 view;
  for (const VertexId v : arrangement.triangulation().sweep_order()) {
    look_around(vertices, arrangement.triangulation(), v, view);
    for_each_gap(vertices, v, view, true, [&](const Gap2& gap) {
      const double length = distance(gap.v, gap.w);
      for_each_term(gap, elements, [&](std::uint32_t i, std::uint32_t j, int sign) {
        pairs.add({pair_key(i, j), sign * (i == j ? 2 : 1) * length});
      });
    });
  }

  std::vector<double> twice_length(elements.count() + 1, 0);
  for (const PieceSideId side : arrangement.sides()) {
    const Segment2& piece = arrangement.piece(side);
    twice_length[elements.of(side)] += 2 * distance(piece.a, piece.b);
  }
  const std::vector<PlainTerm2> sums = pairs.take();
  PlainMatrix matrix;
  matrix.begin.assign(elements.count() + 1, 0);
  const auto each_entry = [&](const auto& visit) {
    for (const PlainTerm2& sum : sums) {
      const std::uint32_t i = sum.i(), j = sum.j();
      if (elements.has_row(i)) visit(i, j, sum.value);
      if (i != j && elements.has_row(j)) visit(j, i, sum.value);
    }
  };
  each_entry([&](std::uint32_t i, std::uint32_t, double) { ++matrix.begin[i + 1]; });
  for (std::uint32_t i = 0; i < elements.count(); ++i) matrix.begin[i + 1] += matrix.begin[i];
  matrix.entries.resize(matrix.begin.back());
  std::vector<std::size_t> next(matrix.begin.begin(), matrix.begin.end() - 1);  // rows ascend, as the keys do
  each_entry([&](std::uint32_t i, std::uint32_t j, double value) {
    matrix.entries[next[i]++] = {j, value / twice_length[i]};
  });
  return matrix;
}

void compare(const ExchangeMatrix& exact, const PlainMatrix& plain, benchmark::State& state) {
  double error = 0;
  for (std::uint32_t i = 0; i < exact.size(); ++i)
    for (const FactorEntry& entry : exact.row(i))
      error = std::max(error, std::fabs(plain.factor(i, entry.to) - entry.factor.value));
  state.counters["max_error"] = error;
  state.counters["false_pairs"] = static_cast<double>(plain.entries.size()) - static_cast<double>(exact.entry_count());
}

void certified(benchmark::State& state, View view, std::uint64_t edges) {
  using Clock = std::chrono::steady_clock;
  const ThreadLimit limit(1);
  const PreparedScene2 prepared = prepare(clutter(view, edges));
  ExchangeRequest options;
  options.wants_visibility = false;
  double exact_seconds = 0, plain_seconds = 0, pairs = 0;
  for (auto _ : state) {
    ExchangeReport report;
    const auto start = Clock::now();
    const ExchangeMatrix exact = exact_exchange(prepared, options, &report);
    const auto middle = Clock::now();
    const PlainMatrix plain = plain_exchange(prepared);
    const auto end = Clock::now();
    const double seconds = std::chrono::duration<double>(middle - start).count();
    exact_seconds += seconds;
    plain_seconds += std::chrono::duration<double>(end - middle).count();
    pairs = static_cast<double>(report.pairs);
    state.SetIterationTime(seconds);
    compare(exact, plain, state);
  }
  const auto iterations = static_cast<double>(state.iterations());
  state.counters["pairs"] = pairs;
  state.counters["us_per_pair"] = 1e6 * exact_seconds / iterations / pairs;
  state.counters["plain_us_per_pair"] = 1e6 * plain_seconds / iterations / pairs;
  state.counters["ratio"] = exact_seconds / plain_seconds;
}

void add(View view, std::uint64_t edges) {
  add_case("certified/" + to_string(view, edges), [=](benchmark::State& state) { certified(state, view, edges); });
}

}  // namespace
}  // namespace hottel::benchmarks

int main(int argc, char** argv) {
  using namespace hottel::benchmarks;
  for (const std::uint64_t edges : {1'000, 10'000}) add(View::kShort, edges);
  for (const std::uint64_t edges : {1'000, 10'000}) add(View::kLong, edges);
  return run(argc, argv);
}

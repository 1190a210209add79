// What long coordinates cost: the same clutter with as few digits as it needs, with 17 digits, and turned and scaled by
// 90-bit numbers so that the vertices need the large form of geometry/plane/predicates/vertices.h.
//
// Each iteration computes the factors of both scenes on one thread. The time reported is that of the scene with long
// coordinates; `ratio` is that time over the time of the scene with short ones, `ratio_exchange` the same without the
// preparation, per visible pair.
#include <benchmark/benchmark.h>

#include "benchmarks/clutter.h"
#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "kernel/support/parallel.h"

namespace hottel::benchmarks {
namespace {

// An exact similarity: every coincidence and every view factor stays what it is.
Scene2 with_large_form(Scene2 scene) {
  const Rational a("1237940039285380274899124357"), b("309485009821345068724781371");
  const auto turn = [&](Point2& p) { p = {a * p.x - b * p.y, b * p.x + a * p.y}; };
  for (Edge2& edge : scene.edges) {
    turn(edge.from);
    turn(edge.to);
  }
  scene.grids.clear();
  return scene;
}

struct Cost {
  double prepare = 0, exchange = 0, pairs = 0;

  void add(const Scene2& scene) {
    Scene2 copy = scene;
    ExchangeReport report;
    const PreparedScene2 prepared = hottel::prepare(std::move(copy));
    benchmark::DoNotOptimize(exact_exchange(prepared, {}, &report).entry_count());
    for (const auto& [stage, time] : report.seconds) (stage == "prepare" ? prepare : exchange) += time;
    pairs += static_cast<double>(report.pairs);
  }
  double total() const { return prepare + exchange; }
};

void digits(benchmark::State& state, const Scene2& plain, const Scene2& detailed) {
  const ThreadLimit limit(1);
  Cost plain_cost, detailed_cost;
  for (auto _ : state) {
    plain_cost.add(plain);
    const double before = detailed_cost.total();
    detailed_cost.add(detailed);
    state.SetIterationTime(detailed_cost.total() - before);
  }
  state.counters["pairs"] = detailed_cost.pairs / static_cast<double>(state.iterations());
  state.counters["ratio"] = detailed_cost.total() / plain_cost.total();
  state.counters["ratio_exchange"] =
      (detailed_cost.exchange / detailed_cost.pairs) / (plain_cost.exchange / plain_cost.pairs);
}

void add(const std::string& name, View view, std::uint64_t edges, Scene2 (*make)(View, std::uint64_t)) {
  add_case("digits/" + name + "/" + to_string(view, edges),
           [=](benchmark::State& state) { digits(state, clutter(view, edges), make(view, edges)); });
}

}  // namespace
}  // namespace hottel::benchmarks

int main(int argc, char** argv) {
  using namespace hottel::benchmarks;
  const auto with_17_digits = [](View view, std::uint64_t edges) { return clutter(view, edges, 17); };
  const auto large = [](View view, std::uint64_t edges) { return with_large_form(clutter(view, edges)); };
  for (const auto& [view, edges] : {std::pair(View::kShort, 10'000), std::pair(View::kLong, 1'000)}) {
    add("17", view, static_cast<std::uint64_t>(edges), with_17_digits);
    add("large-form", view, static_cast<std::uint64_t>(edges), large);
  }
  return run(argc, argv);
}

// What exact view factors cost: clutter of 100 to 100,000 edges, short and long views, on one thread and on two.
//
// Timed: preparation (overlay, triangulation) and exact_exchange, everything `hottel factors` does but reading and
// writing. Counters: visible pairs; microseconds of one core for each of them; milliseconds of each stage; bytes for
// each pair, at the peak and in the matrix that remains.
#include <benchmark/benchmark.h>

#include <map>

#include "benchmarks/clutter.h"
#include "benchmarks/peak_memory.h"
#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "kernel/support/parallel.h"

namespace hottel::benchmarks {
namespace {

void factors(benchmark::State& state, View view, std::uint64_t edges, int threads) {
  const ThreadLimit limit(threads);
  const Scene2 scene = clutter(view, edges);
  std::map<std::string, double> stages;
  double seconds = 0, pairs = 0, peak = 0, remains = 0;
  for (auto _ : state) {
    Scene2 copy = scene;
    const PeakMemory memory;
    ExchangeReport report;
    const PreparedScene2 prepared = prepare(std::move(copy));
    const ExchangeMatrix matrix = exact_exchange(prepared, {}, &report);
    peak = memory.growth();
    remains = static_cast<double>(matrix.entry_count() * ExchangeMatrix::kBytesAnEntry);
    pairs = static_cast<double>(report.pairs);
    double iteration = 0;
    for (const auto& [stage, time] : report.seconds) {
      stages[stage] += time;
      iteration += time;
    }
    seconds += iteration;
    state.SetIterationTime(iteration);
  }
  const auto iterations = static_cast<double>(state.iterations());
  state.counters["pairs"] = pairs;
  state.counters["us_per_pair_core"] = 1e6 * seconds / iterations * threads / pairs;
  for (const char* stage : {"prepare", "label", "sweep", "round", "exact", "matrix"})  // some do not run in every case
    state.counters[std::string("ms_") + stage] = 1e3 * stages[stage] / iterations;
  state.counters["peak_bytes_per_pair"] = peak / pairs;
  state.counters["matrix_bytes_per_pair"] = remains / pairs;
}

void add(View view, std::uint64_t edges, int threads) {
  add_case("factors/" + to_string(view, edges) + "/threads:" + std::to_string(threads),
           [=](benchmark::State& state) { factors(state, view, edges, threads); });
}

}  // namespace
}  // namespace hottel::benchmarks

int main(int argc, char** argv) {
  using namespace hottel::benchmarks;
  for (const int threads : {1, 2})
    for (std::uint64_t edges = 100; edges <= 100'000; edges *= 10) add(View::kShort, edges, threads);
  for (const int threads : {1, 2})
    for (std::uint64_t edges = 100; edges <= 10'000; edges *= 10) add(View::kLong, edges, threads);
  return run(argc, argv);
}

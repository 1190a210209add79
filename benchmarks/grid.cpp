// What light in space costs: grids of 64² to 1024² cells over the apartment and over clutter of 100 to 5,000 edges, on
// one thread and on two.
//
// Timed: illuminate_points (location, views, arc tangents) or illuminate_averages (views of vertices, wedges cut by
// cells) alone; every face sends out a shade of its own in three channels, the worst case. Counters: nanoseconds of one
// core for each cell; vertices seen from a cell on average; the proven error of the averages over the largest
// radiosity, 0 for points.
#include <benchmark/benchmark.h>

#include <atomic>
#include <string>

#include "benchmarks/clutter.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "io/scene/scene_json.h"
#include "kernel/support/parallel.h"
#include "solver/plane/light/average_illumination.h"
#include "solver/plane/light/cell_views.h"

namespace hottel::benchmarks {
namespace {

constexpr std::uint32_t kChannels = 3;

enum class Light : bool { kPoints, kAverages };

void grid(benchmark::State& state, Light light, const Scene2& scene, std::uint32_t side, int threads) {
  const ThreadLimit limit(threads);
  const PreparedScene2 prepared = prepare(scene);
  const ElementTable2& table = *prepared.elements(Granularity::kFace);
  std::vector<double> radiosity;
  for (std::size_t k = 0; k < std::size_t{table.count()} * kChannels; ++k)
    radiosity.push_back(1 + 0.001 * static_cast<double>(k));
  const std::vector<double> sky(kChannels, 0.0);
  const FaceRadiosity2 faces(prepared.arrangement, table, radiosity, sky);
  const SentOut2 sent_out(table, radiosity, sky);
  Scene2 without_grid = scene;
  without_grid.grids.clear();
  const Grid2 cells = grid_over(without_grid, side, side);
  double max_error = 0;
  for (auto _ : state) {
    if (light == Light::kPoints)
      benchmark::DoNotOptimize(illuminate_points(prepared, cells, table, sent_out).values.data());
    else
      max_error = illuminate_averages(prepared, cells, faces).max_error;
  }

  std::atomic<std::size_t> seen{0};
  for_each_cell_view(prepared, cells, {},
                     [&](std::size_t, const Eye2&, const Location2&, const View2& view) { seen += view.seen.size(); });
  const double count = static_cast<double>(side) * side;
  state.counters["ns_per_cell_core"] = benchmark::Counter(
      1e-9 * count / threads, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["seen_per_cell"] = static_cast<double>(seen) / count;
  state.counters["max_error"] = max_error / radiosity.back();
}

void add(Light light, const std::string& scene_name, const Scene2& scene, std::uint32_t side, int threads) {
  const std::string name = (light == Light::kPoints ? "grid/" : "average/") + scene_name +
                           "/edges:" + std::to_string(scene.surfaces.size()) + "/cells:" + std::to_string(side) + "x" +
                           std::to_string(side) + "/threads:" + std::to_string(threads);
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { grid(state, light, scene, side, threads); })
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
}

}  // namespace
}  // namespace hottel::benchmarks

int main(int argc, char** argv) {
  using namespace hottel::benchmarks;
  const hottel::Scene2 apartment = hottel::read_scene_2("scenes/showcase/apartment.json");
  for (const int threads : {1, 2}) {
    for (const std::uint32_t side : {64u, 256u, 1024u}) add(Light::kPoints, "apartment", apartment, side, threads);
    for (const std::uint64_t edges : {100, 300, 1000, 5000}) {
      add(Light::kPoints, "clutter-short", clutter(View::kShort, edges), 256, threads);
      add(Light::kPoints, "clutter-long", clutter(View::kLong, edges), 256, threads);
    }
    for (const std::uint32_t side : {64u, 256u, 1024u}) add(Light::kAverages, "apartment", apartment, side, threads);
    for (const std::uint64_t edges : {100, 300}) {
      add(Light::kAverages, "clutter-short", clutter(View::kShort, edges), 256, threads);
      add(Light::kAverages, "clutter-long", clutter(View::kLong, edges), 256, threads);
    }
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}

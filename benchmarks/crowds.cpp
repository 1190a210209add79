// What it costs where many edges are at one place, and where the grid is coarse: does the time grow with the size of
// the scene, or with its square?
//
// Cases: n edges on top of each other, n edges that each cover a third of the next along one line, n edges from one
// point (a wheel, and a narrow fan), all twice: preparation and exact view factors, then what `hottel check` looks for
// in the geometry; and pictures of light on 1 x 1 to 256 x 256 cells, in the apartment and over a polygon of 500 sides.
// Counter: nanoseconds for each edge, or each pixel of the picture: what grows from line to line grows too fast.
#include <benchmark/benchmark.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "geometry/plane/check/contacts.h"
#include "geometry/plane/check/near_misses.h"
#include "geometry/plane/exchange/exchange.h"
#include "io/scene/scene_json.h"
#include "solver/plane/light/illumination_grid.h"
#include "viewer/picture/plane/light_pixels.h"

namespace hottel::benchmarks {
namespace {

Scene2 scene_of(std::int64_t count, const std::function<Edge2(std::int64_t)>& edge) {
  Scene2 scene;
  scene.file = "crowd";
  scene.materials.push_back({"white", {}, {}});
  for (std::int64_t k = 0; k < count; ++k) {
    scene.groups.push_back("edge[" + std::to_string(k) + "]");
    Surface surface;
    surface.name = scene.groups.back().name;
    surface.group = static_cast<std::uint32_t>(k);
    scene.add(std::move(surface), edge(k));
  }
  return scene;
}

Point2 on_circle(std::int64_t k, std::int64_t count) {
  const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(count);
  return {std::lround(1e6 * std::cos(angle)), std::lround(1e6 * std::sin(angle))};
}

Scene2 crowd(const std::string& kind, std::int64_t n) {
  return scene_of(n, [&](std::int64_t k) -> Edge2 {
    const long place = k;
    if (kind == "equal") return k % 2 == 0 ? Edge2{{0, 0}, {1, 0}} : Edge2{{1, 0}, {0, 0}};
    if (kind == "chain") return {{2 * place, 0}, {2 * place + 3, 0}};
    if (kind == "wheel") return {{0, 0}, on_circle(k, n)};
    return {{0, 0}, {1'000'000, place}};
  });
}

void factors(benchmark::State& state, const std::string& kind) {
  const Scene2 scene = crowd(kind, state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(exact_exchange(prepare(scene), {.wants_visibility = false}).size());
  state.counters["ns_each"] =
      benchmark::Counter(1e-9 * static_cast<double>(state.range(0)),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void check(benchmark::State& state, const std::string& kind) {
  const Scene2 scene = crowd(kind, state.range(0));
  for (auto _ : state) {
    benchmark::DoNotOptimize(find_contacts(scene).overlaps.size());
    benchmark::DoNotOptimize(find_near_misses(scene).size());
  }
  state.counters["ns_each"] =
      benchmark::Counter(1e-9 * static_cast<double>(state.range(0)),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

// About a million pixels, whatever the cells.
void picture(benchmark::State& state, const Scene2& scene) {
  const auto cells = static_cast<std::uint32_t>(state.range(0));
  constexpr std::uint32_t kSide = 1024;
  Scene2 without_grid = scene;
  without_grid.grids.clear();
  IlluminationGrid2 grid{grid_over(without_grid, cells, cells), 1, {}};
  for (std::uint32_t k = 0; k < cells * cells; ++k) grid.values.push_back(k % 7);
  for (auto _ : state) {
    const LightPixels2 pixels(grid, kSide / cells, kSide / cells, &scene);
    for (std::uint32_t iy = 0; iy < cells; ++iy) benchmark::DoNotOptimize(pixels.row_of_cells(iy).data());
  }
  state.counters["ns_each"] = benchmark::Counter(
      1e-9 * kSide * kSide, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

}  // namespace
}  // namespace hottel::benchmarks

int main(int argc, char** argv) {
  using namespace hottel::benchmarks;
  for (const std::string kind : {"equal", "chain", "wheel", "narrow"})
    for (const bool is_check : {false, true})
      benchmark::RegisterBenchmark(("crowds/" + kind + (is_check ? "/check" : "/factors")).c_str(),
                                   [=](benchmark::State& state) { (is_check ? check : factors)(state, kind); })
          ->Arg(1000)
          ->Arg(4000)
          ->Arg(16000)
          ->ArgName("edges")
          ->Unit(benchmark::kMillisecond);
  const hottel::Scene2 apartment = hottel::read_scene_2("scenes/showcase/apartment.json");
  const hottel::Scene2 polygon = scene_of(500, [](std::int64_t k) {
    return hottel::Edge2{on_circle(k + 1, 500), on_circle(k, 500)};
  });
  for (const auto& [name, scene] : {std::pair("apartment", apartment), std::pair("polygon", polygon)})
    benchmark::RegisterBenchmark((std::string("crowds/picture/") + name).c_str(),
                                 [scene = scene](benchmark::State& state) { picture(state, scene); })
        ->Arg(1)
        ->Arg(4)
        ->Arg(16)
        ->Arg(64)
        ->Arg(256)
        ->ArgName("cells")
        ->Unit(benchmark::kMillisecond);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}

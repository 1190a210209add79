// What the module of Python costs over the library in C++: the same work, once by each, in turns.
//
//   visible   visibility polygons of 100,000 points, corners rounded: visibility_polygons of exact points, against
//             Simulation.visible of an array of doubles
//   light     the mean irradiance at 10,000 points of a scene that is solved
//   factors   a scene in memory to its view factors
//   program   a scene file to a file of factors (.npy): the program, against a process of Python, both from their start
//   to_scipy  a matrix of scipy.sparse that shares the arrays of the library, against a copy
//
// `time` is that of Python, `other_ms` of what it is held against, `ratio` the first over the second; `count` how many
// points or entries. Each is the median of seven calls. `visible`, `light` and `factors` are processor time of one
// thread, or with `threads:2` by the clock, as are `program` and `to_scipy`. This program takes memory as Python does,
// without jemalloc.
#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "benchmarks/clutter.h"
#include "benchmarks/folder.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/visibility/point_location.h"
#include "geometry/plane/visibility/polygons_of_points.h"
#include "io/scene/scene_json.h"
#include "kernel/support/parallel.h"
#include "solver/plane/light/point_lights.h"
#include "solver/plane/simulation/queries.h"
#include "solver/plane/simulation/simulation.h"

namespace hottel::benchmarks {
namespace {

constexpr int kCalls = 7;

// Seconds of this process, of its threads together if there is one.
double now(int threads) {
  if (threads == 1) return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// The median of the seconds that so many calls take.
template <class Work>
double median_seconds(int threads, const Work& work) {
  const ThreadLimit limit(threads);
  std::vector<double> seconds;
  for (int k = 0; k < kCalls; ++k) {
    const double begin = now(threads);
    work();
    seconds.push_back(now(threads) - begin);
  }
  std::ranges::sort(seconds);
  return seconds[kCalls / 2];
}

// What a command of the shell prints.
std::string printed_by(const std::string& command) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"), &pclose);
  if (!pipe) throw std::runtime_error("cannot start " + command);
  std::string text;
  for (char part[256]; std::fgets(part, sizeof part, pipe.get()) != nullptr;) text += part;
  return text;
}

// What benchmarks/python_side/measure.py measures: seconds of one or two kinds of work, and how many things there were.
struct Measured {
  double seconds = 0, other_seconds = 0, count = 0;
};
Measured by_python(const std::string& what, int threads, const std::string& scene, const std::string& points = "") {
  const std::string text =
      printed_by(fmt::format("PYTHONPATH={} {} {} {} {} {} {} {}", HOTTEL_PYTHON_PATH, HOTTEL_PYTHON,
                             HOTTEL_PYTHON_SIDE, what, kCalls, threads, scene, points));
  Measured measured;
  if (std::sscanf(text.c_str(), "%lf %lf %lf", &measured.seconds, &measured.other_seconds, &measured.count) != 3)
    throw std::runtime_error("Python says: " + text);
  return measured;
}

void report(benchmark::State& state, const Measured& measured) {
  state.SetIterationTime(measured.seconds);
  state.counters["other_ms"] = 1e3 * measured.other_seconds;
  state.counters["ratio"] = measured.seconds / measured.other_seconds;
  state.counters["count"] = measured.count;
}

// Points of three decimals within a scene, as a file for Python and exactly.
std::vector<Point2> drawn_points(const Scene2& scene, std::size_t count, const std::string& file) {
  const auto [x, y] = std::pair(std::minmax_element(scene.edges.begin(), scene.edges.end(),
                                                    [](const auto& a, const auto& b) { return a.from.x < b.from.x; }),
                                std::minmax_element(scene.edges.begin(), scene.edges.end(),
                                                    [](const auto& a, const auto& b) { return a.from.y < b.from.y; }));
  std::mt19937_64 engine(1);
  const auto thousandths = [&engine](const Rational& low, const Rational& high) {
    const double from = std::ceil(1000 * to_double(low)), to = std::floor(1000 * to_double(high));
    return static_cast<long>(from + (to - from) * static_cast<double>(engine() >> 11) * 0x1p-53);
  };
  std::vector<Point2> points;
  std::ofstream out(file);
  for (std::size_t k = 0; k < count; ++k) {
    const long px = thousandths(x.first->from.x, x.second->from.x), py = thousandths(y.first->from.y, y.second->from.y);
    out << fmt::format("{}e-3,{}e-3\n", px, py);
    points.push_back({Rational(px) / 1000, Rational(py) / 1000});
  }
  return points;
}

// Writes the scene as scene.json.
void write(const Scene2& scene, const Folder& folder) {
  std::ofstream(folder.file("scene.json")) << write_scene_2(scene);
}

void visible(benchmark::State& state, const Scene2& scene, std::size_t count, int threads) {
  const Folder folder("python-visible");
  write(scene, folder);
  const std::vector<Point2> points = drawn_points(scene, count, folder.file("points.csv"));
  const Simulation2 simulation(scene);
  for (auto _ : state) {
    Measured measured = by_python("visible", threads, folder.file("scene.json"), folder.file("points.csv"));
    const auto prepared = simulation.prepared();
    measured.other_seconds =
        median_seconds(threads, [&] { benchmark::DoNotOptimize(visibility_polygons(*prepared, points).data()); });
    report(state, measured);
  }
}

void light(benchmark::State& state, const Scene2& scene, std::size_t count, int threads) {
  const Folder folder("python-light");
  write(scene, folder);
  const std::vector<Point2> points = drawn_points(scene, count, folder.file("points.csv"));
  const Simulation2 simulation(scene);
  const PointLights2 lights = point_lights(simulation);
  for (auto _ : state) {
    Measured measured = by_python("light", threads, folder.file("scene.json"), folder.file("points.csv"));
    measured.other_seconds = median_seconds(threads, [&] {
      const Arrangement2& arrangement = lights.prepared().arrangement;
      const PointLocation2 location(arrangement.vertices(), arrangement.triangulation());
      std::vector<std::vector<double>> found(points.size());
      parallel_for(points.size(), [&](std::size_t k) { found[k] = lights.at(location, points[k]); });
      benchmark::DoNotOptimize(found.data());
    });
    report(state, measured);
  }
}

void factors(benchmark::State& state, const Scene2& scene, int threads) {
  const Folder folder("python-factors");
  write(scene, folder);
  for (auto _ : state) {
    Measured measured = by_python("factors", threads, folder.file("scene.json"));
    measured.other_seconds = median_seconds(threads, [&] { benchmark::DoNotOptimize(Simulation2(scene).factors()); });
    report(state, measured);
  }
}

void program(benchmark::State& state, const Scene2& scene) {
  const Folder folder("python-program");
  write(scene, folder);
  const std::string python = fmt::format("PYTHONPATH={} {} {} program 1 2 {} {}", HOTTEL_PYTHON_PATH, HOTTEL_PYTHON,
                                         HOTTEL_PYTHON_SIDE, folder.file("scene.json"), folder.file("python.npy"));
  const std::string own = fmt::format("{} factors {} -o {} 2>/dev/null", HOTTEL_PROGRAM, folder.file("scene.json"),
                                      folder.file("program.npy"));
  for (auto _ : state) {
    Measured measured;
    measured.seconds = median_seconds(2, [&] { printed_by(python); });
    measured.other_seconds = median_seconds(2, [&] { printed_by(own); });
    measured.count = static_cast<double>(Simulation2(scene).factors()->matrix.entry_count());
    report(state, measured);
  }
}

void to_scipy(benchmark::State& state, const Scene2& scene) {
  const Folder folder("python-scipy");
  write(scene, folder);
  for (auto _ : state) report(state, by_python("to_scipy", 2, folder.file("scene.json")));
}

// One iteration, whose calls are counted here.
void add(const std::string& name, const std::function<void(benchmark::State&)>& measure) {
  benchmark::RegisterBenchmark(name.c_str(), measure)->UseManualTime()->Iterations(1)->Unit(benchmark::kMillisecond);
}

int run_python(int argc, char** argv) {
  const Scene2 apartment = read_scene_2("scenes/showcase/apartment.json");
  const Scene2 thousand = clutter(View::kShort, 1000), many = clutter(View::kLong, 5000);
  constexpr std::size_t kQueries = 100'000, kLights = 10'000;
  for (const int threads : {1, 2}) {
    const std::string end = fmt::format("/threads:{}", threads);
    for (const auto& [name, scene] : {std::pair("apartment", &apartment), std::pair("short/edges:1000", &thousand)}) {
      add(fmt::format("visible/{}{}", name, end),
          [=](benchmark::State& state) { visible(state, *scene, kQueries, threads); });
      add(fmt::format("light/{}{}", name, end),
          [=](benchmark::State& state) { light(state, *scene, kLights, threads); });
      add(fmt::format("factors/{}{}", name, end), [=](benchmark::State& state) { factors(state, *scene, threads); });
    }
  }
  add("program/apartment", [&](benchmark::State& state) { program(state, apartment); });
  add("program/short/edges:1000", [&](benchmark::State& state) { program(state, thousand); });
  add("to_scipy/apartment", [&](benchmark::State& state) { to_scipy(state, apartment); });
  add("to_scipy/long/edges:5000", [&](benchmark::State& state) { to_scipy(state, many); });
  return run(argc, argv);
}

}  // namespace
}  // namespace hottel::benchmarks

int main(int argc, char** argv) { return hottel::benchmarks::run_python(argc, argv); }

// What it costs to see all that is seen from a point of space: map_from, in rooms full of boxes.
//
// Rooms of 102 to 9,996 polygons: boxes along the axes on a lattice, and turned ones (space_scenes.h). Eyes stand near
// corners of cells, where no box is, drawn by seed; there are 40, and every iteration makes the map of each, on one
// thread. Counters: ms of a map, the median and the largest of these, and that over the median; us of the median map
// for each polygon; fragments of a map, planes that bound them, and signs of a map by what settled them: doubles, equal
// numbers, integers.
#include <benchmark/benchmark.h>

#include <string>
#include <utility>
#include <vector>

#include "benchmarks/clutter.h"
#include "benchmarks/space_scenes.h"
#include "geometry/space/visibility/visibility_map.h"
#include "kernel/support/parallel.h"
#include "kernel/support/stopwatch.h"

namespace hottel::benchmarks {
namespace {

constexpr int kEyes = 40;

std::vector<Point3> eyes_3(int cells) {
  Dice3 dice(2);
  const auto place = [&] {
    const int corner = dice.roll(1, cells - 1);
    return ratio(1024 * corner + dice.roll(-40, 40), 1024);
  };
  std::vector<Point3> eyes;
  for (int k = 0; k < kEyes; ++k) {
    Point3 eye{place(), place(), place()};
    eyes.push_back(std::move(eye));
  }
  return eyes;
}

void maps(benchmark::State& state, std::size_t boxes, bool are_turned) {
  const DefaultFloatingPoint arithmetic;
  const Scene3 scene = full_room_3(boxes, are_turned);
  const Occluders3 occluders(scene.polygons);
  const std::vector<Point3> eyes = eyes_3(cells_for(boxes));
  std::vector<double> seconds;
  double fragments = 0, planes = 0;
  SignCounts signs;
  for (auto _ : state) {
    double iteration = 0;
    for (const Point3& eye : eyes) {
      Stopwatch watch;
      const VisibilityMap3 map = map_from(occluders, {.eye = eye, .normal = {}});
      seconds.push_back(watch.lap());
      iteration += seconds.back();
      fragments += static_cast<double>(map.fragments.size());
      planes += static_cast<double>(map.planes.size());
      signs += map.signs;
    }
    state.SetIterationTime(iteration);
  }
  const double median = quantile(seconds, 0.5), largest = quantile(seconds, 1),
               count = static_cast<double>(seconds.size());
  state.counters["ms_map"] = 1e3 * median;
  state.counters["ms_largest"] = 1e3 * largest;
  state.counters["ratio"] = largest / median;
  state.counters["us_per_polygon"] = 1e6 * median / static_cast<double>(occluders.size());
  state.counters["fragments"] = fragments / count;
  state.counters["planes"] = planes / count;
  const char* const kTiers[] = {"filter", "combinatorial", "exact"};
  for (std::size_t tier = 0; tier < 3; ++tier)
    state.counters[std::string("signs_") + kTiers[tier]] = static_cast<double>(signs.by_tier[tier]) / count;
}

void add(std::size_t boxes, bool are_turned) {
  const std::string name =
      std::string("space_maps/") + (are_turned ? "turned" : "axis") + "/polygons:" + std::to_string(6 + 6 * boxes);
  add_case(name, [=](benchmark::State& state) { maps(state, boxes, are_turned); });
}

}  // namespace
}  // namespace hottel::benchmarks

int main(int argc, char** argv) {
  using namespace hottel::benchmarks;
  for (const bool are_turned : {false, true})
    for (const std::size_t boxes : {16, 49, 165, 500, 1665}) add(boxes, are_turned);
  return run(argc, argv);
}

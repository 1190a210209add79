// What a pair of patches in space costs, by how many surfaces stand between them: 1 to 200 of six kinds, 32 of a soup.
//
//   plates  upright, behind each other and each a little higher, before a wall: from that wall to one behind all
//   slats   a blind between a floor and a ceiling that are as long as it is
//   prism   a prism with so many sides between two squares
//   fan     triangles around one point, above a floor
//   boxes   on a lattice, between a floor and a ceiling; a box is six surfaces
//   soup    triangles anywhere between a floor and a ceiling
//
// Each pair is measured alone, with nothing known of its patches, on one thread. `step` is the time over that with one
// surface less, where both are above a hundredth of a second.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "benchmarks/clutter.h"
#include "benchmarks/space_scenes.h"
#include "geometry/space/arrangement/whole_patch.h"
#include "geometry/space/generate/generators.h"
#include "geometry/space/pairs/pair_integrator.h"
#include "kernel/support/parallel.h"
#include "kernel/support/stopwatch.h"

namespace hottel::benchmarks {
namespace {

constexpr std::array<const char*, 6> kKinds{"plates", "slats", "prism", "fan", "boxes", "soup"};
constexpr std::array<int, 6> kMost{200, 200, 200, 200, 200, 32};  // surfaces that take no minute

using Points = std::vector<Point3>;

Points level(const Rational& width, const Rational& depth, const Rational& z, bool faces_up) {
  Points points{{0, 0, z}, {width, 0, z}, {width, depth, z}, {0, depth, z}};
  if (!faces_up) std::reverse(points.begin(), points.end());
  return points;
}

void add_plates(std::vector<Points>& polygons, int n) {
  polygons.push_back({{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}});
  const Rational x = n + 1;
  polygons.push_back({{x, 0, 0}, {x, 0, 1}, {x, 1, 1}, {x, 1, 0}});
  for (int k = 0; k < n; ++k) {
    const Rational at = k + 1, high = ratio(n + k, 3 * n);
    polygons.push_back({{at, 0, 0}, {at, 1, 0}, {at, 1, high}, {at, 0, high}});
  }
}

void add_slats(std::vector<Points>& polygons, int n) {
  polygons.push_back(level(n, 4, 0, true));
  polygons.push_back(level(n, 4, 3, false));
  for (int k = 0; k < n; ++k) {
    const Rational from = ratio(4 * k + 1, 4), to = ratio(2 * k + 1, 2);
    polygons.push_back({{from, 0, 1}, {to, 0, 2}, {to, 4, 2}, {from, 4, 1}});
  }
}

// Points of a circle by tan(a / 2) in fractions, a quarter at a time: exact.
Points circle(int n, const Rational& y, const Rational& radius) {
  Points points;
  for (int k = 0; k < n; ++k) {
    const int quarter = 4 * k / n;
    const Rational t = ratio(4 * k - quarter * n, n), square = 1 + t * t;
    const Rational c = radius * (1 - t * t) / square, s = radius * 2 * t / square;
    const Rational half = ratio(1, 2);
    const std::array<Point3, 4> turned{Point3{half + c, y, half + s}, Point3{half - s, y, half + c},
                                       Point3{half - c, y, half - s}, Point3{half + s, y, half - c}};
    points.push_back(turned[static_cast<std::size_t>(quarter)]);
  }
  return points;
}

void add_prism(std::vector<Points>& polygons, int n) {
  polygons.push_back(level(1, 1, 0, true));
  polygons.push_back(level(1, 1, 1, false));
  const int sides = std::max(3, n - 2);
  const Points low = circle(sides, 0, ratio(1, 4)), high = circle(sides, 1, ratio(1, 4));
  for (std::size_t k = 0; k < low.size(); ++k) {
    const std::size_t next = (k + 1) % low.size();
    polygons.push_back({low[k], high[k], high[next], low[next]});
  }
  polygons.push_back(low);
  polygons.emplace_back(high.rbegin(), high.rend());
}

void add_fan(std::vector<Points>& polygons, int n) {
  polygons.push_back(level(10, 10, 0, true));
  polygons.push_back(level(10, 10, 2, false));
  const auto rim = [n](int k) { return Point3{10, ratio(10 * k, n), ratio(10 + k % 3, 10)}; };
  for (int k = 0; k < n; ++k) polygons.push_back({{0, 0, 1}, rim(k), rim(k + 1)});
}

void add_boxes(std::vector<Points>& polygons, int n) {
  polygons.push_back(level(1, 1, 0, true));
  polygons.push_back(level(1, 1, 1, false));
  constexpr int kCells = 4;
  Dice3 dice(2);
  for (int k = 0; k < n / 6; ++k) {
    const auto side = [&](int cell) {
      const int low = 16 * cell + dice.roll(1, 6);
      return std::pair(ratio(low, 16 * kCells), ratio(low + dice.roll(3, 8), 16 * kCells));
    };
    const auto [x0, x1] = side(k % kCells);
    const auto [y0, y1] = side(k / kCells % kCells);
    const auto [z0, z1] = side(k / kCells / kCells * 2 % kCells + k % 2);
    polygons.push_back({{x0, y0, z1}, {x1, y0, z1}, {x1, y1, z1}, {x0, y1, z1}});
    polygons.push_back({{x0, y0, z0}, {x0, y1, z0}, {x1, y1, z0}, {x1, y0, z0}});
    polygons.push_back({{x0, y0, z0}, {x1, y0, z0}, {x1, y0, z1}, {x0, y0, z1}});
    polygons.push_back({{x1, y0, z0}, {x1, y1, z0}, {x1, y1, z1}, {x1, y0, z1}});
    polygons.push_back({{x1, y1, z0}, {x0, y1, z0}, {x0, y1, z1}, {x1, y1, z1}});
    polygons.push_back({{x0, y1, z0}, {x0, y0, z0}, {x0, y0, z1}, {x0, y1, z1}});
  }
}

void add_soup(std::vector<Points>& polygons, int n) {
  polygons.push_back(level(1, 1, 0, true));
  polygons.push_back(level(1, 1, 1, false));
  Dice3 dice(5);
  for (int k = 0; k < n; ++k) {
    const Point3 at{ratio(dice.roll(200, 800), 1000), ratio(dice.roll(200, 800), 1000),
                    ratio(dice.roll(200, 800), 1000)};
    const auto near = [&]() -> Point3 {
      const auto off = [&] { return ratio(dice.roll(-150, 150), 1000); };
      const Rational x = off(), y = off(), z = off();
      return {at.x + x, at.y + y, at.z + z};
    };
    const Point3 a = near(), b = near(), c = near();
    polygons.push_back({a, b, c});
  }
}

std::vector<Polygon3> scene(std::size_t kind, int n) {
  constexpr std::array kAdd{add_plates, add_slats, add_prism, add_fan, add_boxes, add_soup};
  std::vector<Points> all;
  kAdd[kind](all, n);
  std::vector<Polygon3> polygons;
  for (Points& points : all) polygons.push_back({std::move(points)});
  return polygons;
}

double seconds_of(std::size_t kind, int n, PairResult3& pair) {
  const Occluders3 occluders(scene(kind, n));
  const PairIntegrator3 measurer(occluders);
  const Patch3 i = whole_patch(occluders, 0), j = whole_patch(occluders, 1);
  Stopwatch watch;
  pair = measurer.measure(i, j, {.tolerance = 1e-6});
  return watch.lap();
}

void between(benchmark::State& state, std::size_t kind, int n) {
  const ThreadLimit limit(1);
  const DefaultFloatingPoint arithmetic;
  for (auto _ : state) {
    PairResult3 before, pair;
    const double with_less = n > 1 ? seconds_of(kind, n - 1, before) : 0;
    const double seconds = seconds_of(kind, n, pair);
    state.SetIterationTime(seconds);
    state.counters["step"] = with_less > 0.01 && seconds > 0.01 ? seconds / with_less : 1;
    state.counters["maps"] = pair.maps;
    state.counters["pieces"] = pair.pieces;
    state.counters["failed"] = !pair.problem.empty();
    state.counters["measure"] = pair.measure;
  }
}

}  // namespace
}  // namespace hottel::benchmarks

int main(int argc, char** argv) {
  using namespace hottel::benchmarks;
  for (std::size_t kind = 0; kind < kKinds.size(); ++kind)
    for (const int n : {1, 2, 4, 8, 12, 16, 20, 24, 28, 30, 31, 32, 36, 40, 48, 64, 96, 128, 160, 200})
      if (n <= kMost[kind])
        add_case(fmt::format("space_between/{}/surfaces:{}", kKinds[kind], n),
                 [=](benchmark::State& state) { between(state, kind, n); });
  return run(argc, argv);
}

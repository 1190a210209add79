#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "geometry/plane/generate/generators.h"
#include "kernel/support/interrupt.h"
#include "kernel/support/parallel.h"
#include "solver/plane/light/average_illumination.h"
#include "tests/oracle/gauss_rule.h"
#include "tests/solver/plane/lit_scenes.h"

namespace hottel::illumination_average_test {
namespace {

using testing::Each;

AverageIllumination2 averages(const Lit& lit, const Grid2& cells) {
  return illuminate_averages(lit.prepared, cells, lit.faces());
}

Scene2 clutter(unsigned edges) {
  GeneratorRequest2 request;
  request.kind = "clutter";
  request.n = edges;
  request.seed = 2;
  return generate_2(request);
}

// The mean over each cell of exact values at the centres of s times s parts of it.
std::vector<double> means_of_points(const Lit& lit, const Grid2& cells, std::uint32_t s) {
  const IlluminationGrid2 points = lit.grid({cells.min, cells.max, cells.nx * s, cells.ny * s});
  std::vector<double> mean(std::size_t{cells.nx} * cells.ny * points.channels);
  for (std::uint32_t iy = 0; iy < cells.ny * s; ++iy)
    for (std::uint32_t ix = 0; ix < cells.nx * s; ++ix)
      for (std::uint32_t c = 0; c < points.channels; ++c)
        mean[(std::size_t{iy / s} * cells.nx + ix / s) * points.channels + c] += points.at(ix, iy, c) / (s * s);
  return mean;
}

double largest_distance(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, std::fabs(a[k] - b[k]));
  return largest;
}

// No edge in a room means no kink: the light is harmonic, the midpoint rule is off by a term of fourth order, which
// Richardson takes away.
TEST(AverageIllumination2, IsTheLimitOfDenseGridsOfPoints) {
  Scene2 hexagon;
  add_polygon(hexagon, {{0, 0}, {-1, 3}, {2, 5}, {6, 4}, {7, 1}, {3, -1}});
  const Lit lit(hexagon, 3);
  const Grid2 cells{{1, 1}, {5, 3}, 6, 3};
  const AverageIllumination2 average = averages(lit, cells);
  const std::vector<double> coarse = means_of_points(lit, cells, 8), fine = means_of_points(lit, cells, 16);
  std::vector<double> limit(fine);
  for (std::size_t k = 0; k < fine.size(); ++k) limit[k] += (fine[k] - coarse[k]) / 15;
  EXPECT_LT(largest_distance(average.grid.values, coarse), 1e-5);
  EXPECT_LT(largest_distance(average.grid.values, limit), 1e-8);
}

// With kinks along critical lines the midpoint rule still is of second order; where edges cut cells the light jumps,
// and it is of the first: at most the largest radiosity times the part of the samples whose squares an edge meets.
TEST(AverageIllumination2, IsTheLimitOfDenseGridsOfPointsAmongEdges) {
  for (const Scene2& scene : {pillar_room(), random_lattice_scene(3, 14), random_lattice_scene(6, 18)}) {
    const Lit lit(scene, 3);
    const Grid2 cells = default_grid(lit.prepared.scene, 9);
    const AverageIllumination2 average = averages(lit, cells);
    double before = HUGE_VAL;
    for (const std::uint32_t s : {4u, 16u, 64u}) {
      const double distance = largest_distance(average.grid.values, means_of_points(lit, cells, s));
      EXPECT_LT(distance, before / 2.5) << s;
      before = distance;
    }
    EXPECT_LT(before, 10 * 4.0 / 64);
  }
}

TEST(AverageIllumination2, IsBWhereEverythingSeenSendsOutB) {
  const double b = 0.7;
  Scene2 convex;
  add_polygon(convex, {{0, 0}, {-1, 3}, {2, 5}, {6, 4}, {7, 1}, {3, -1}});
  const Lit hexagon(convex, 1, b);
  const AverageIllumination2 inside = averages(hexagon, {{1, 0}, {5, 3}, 40, 30});
  for (std::size_t k = 0; k < inside.errors.size(); ++k) EXPECT_NEAR(inside.grid.values[k], b, inside.errors[k]);
  EXPECT_LT(inside.max_error, 1e-11);

  const Lit pillar(pillar_room(), 1, b);  // its borders are borders of cells: cells are in it or outside
  const AverageIllumination2 around = averages(pillar, {{0, 0}, {1, 1}, 20, 20});
  for (std::size_t k = 0; k < around.errors.size(); ++k) {
    const std::size_t ix = k % 20, iy = k / 20;
    const bool is_solid = ix >= 8 && ix < 12 && iy >= 8 && iy < 12;
    EXPECT_NEAR(around.grid.values[k], is_solid ? 0 : b, around.errors[k]) << k;
  }
}

TEST(AverageIllumination2, KnowsAStripLight) {
  Scene2 scene;  // its front looks down
  add_edge(scene, {-1, 0}, {1, 0});
  Lit lit(scene, 1, 0);
  lit.by_element = {8, 8};
  const GaussRule rule(48);
  const auto irradiance = [](long double x, long double y) {
    return 8 * (std::atan((1 - x) / y) + std::atan((1 + x) / y)) / (2 * std::numbers::pi_v<long double>);
  };
  for (const double sky : {0.0, 0.5}) {
    lit.sky = {sky};
    const AverageIllumination2 light = averages(lit, {{-2, -2}, {2, Rational(-1, 2)}, 8, 3});
    for (std::uint32_t iy = 0; iy < 3; ++iy)
      for (std::uint32_t ix = 0; ix < 8; ++ix) {
        long double mean = 0;
        for (std::size_t i = 0; i < rule.node.size(); ++i)
          for (std::size_t j = 0; j < rule.node.size(); ++j)
            mean +=
                rule.weight[i] * rule.weight[j] * irradiance(-2 + (ix + rule.node[i]) / 2, 2 - (iy + rule.node[j]) / 2);
        mean += sky * (1 - mean / 8);
        const std::size_t cell = std::size_t{iy} * 8 + ix;
        EXPECT_NEAR(light.grid.values[cell], static_cast<double>(mean), light.errors[cell]);
      }
    EXPECT_LT(light.max_error, 1e-11);
  }
}

TEST(AverageIllumination2, IsTheMeanOfItsQuarters) {
  std::vector<Scene2> scenes{pillar_room(), clutter(40)};
  for (unsigned seed = 1; seed <= 6; ++seed) scenes.push_back(random_lattice_scene(seed, 12 + static_cast<int>(seed)));
  for (Scene2& scene : scenes) {
    scene.closed = false;  // else a cell is the mean over what of it is inside
    const Lit lit(scene, 2);
    Grid2 cells = default_grid(lit.prepared.scene, 11);
    cells.max.x += 1;
    const AverageIllumination2 whole = averages(lit, cells);
    const AverageIllumination2 quarters = averages(lit, {cells.min, cells.max, 2 * cells.nx, 2 * cells.ny});
    for (std::uint32_t iy = 0; iy < cells.ny; ++iy)
      for (std::uint32_t ix = 0; ix < cells.nx; ++ix)
        for (std::uint32_t c = 0; c < 2; ++c) {
          double mean = 0, error = whole.errors[std::size_t{iy} * cells.nx + ix];
          for (const std::uint32_t dy : {0u, 1u})
            for (const std::uint32_t dx : {0u, 1u}) {
              mean += quarters.grid.at(2 * ix + dx, 2 * iy + dy, c) / 4;
              error += quarters.errors[(std::size_t{2} * iy + dy) * 2 * cells.nx + 2 * ix + dx] / 4;
            }
          ASSERT_NEAR(whole.grid.at(ix, iy, c), mean, error) << ix << " " << iy;
        }
    EXPECT_LT(whole.max_error, 1e-9);
  }
}

TEST(AverageIllumination2, IsBlackBehindBlackBacksUpToItsBound) {
  const Lit lit(pillar_room(), 2, 3);  // the sky sends out 3 as well
  const AverageIllumination2 light =
      averages(lit, {{Rational(2, 5), Rational(2, 5)}, {Rational(3, 5), Rational(3, 5)}, 4, 4});
  for (std::size_t k = 0; k < light.errors.size(); ++k) EXPECT_LE(light.grid.at(k % 4, k / 4 % 4), light.errors[k]);
  Lit dark(pillar_room(), 1, 3);
  dark.sky = {0};
  EXPECT_THAT(averages(dark, {{-5, 2}, {5, 3}, 10, 3}).grid.values, Each(0.0));  // outside, only black backs
}

TEST(AverageIllumination2, CellsThatEdgesCutAreTheMeanOfTheirParts) {
  Scene2 scene;  // black above, 8 below, endless for the cells near its middle
  add_edge(scene, {-1000000, 0}, {1000000, 0});
  Lit lit(scene, 1, 0);
  lit.by_element = {8, 8};
  const double below = 4, above = 0;  // half a turn of it, and half a turn of dark sky
  EXPECT_NEAR(averages(lit, {{-1, -1}, {1, 1}, 1, 1}).grid.values[0], (below + above) / 2, 1e-5);
  EXPECT_NEAR(averages(lit, {{-1, -3}, {1, 1}, 1, 1}).grid.values[0], (3 * below + above) / 4, 1e-5);
  EXPECT_NEAR(averages(lit, {{-1, 0}, {1, 1}, 1, 1}).grid.values[0], above, 1e-5);  // the edge is a border
  lit.sky = {1};
  EXPECT_NEAR(averages(lit, {{-1, -1}, {1, 1}, 1, 1}).grid.values[0], (below + 0.5 + above + 0.5) / 2, 1e-5);
}

TEST(AverageIllumination2, IsDefinedInScenesOnOneLineAndWithoutEdges) {
  Scene2 scene;
  add_edge(scene, {0, 0}, {1, 0}, true);
  add_edge(scene, {2, 0}, {3, 0}, true);
  const Lit lit(scene, 1, 2);
  const AverageIllumination2 light = averages(lit, {{Rational(-3, 4), -1}, {Rational(15, 4), 1}, 9, 3});
  for (std::size_t k = 0; k < light.errors.size(); ++k) EXPECT_NEAR(light.grid.values[k], 2, light.errors[k]);
  EXPECT_THAT(averages(Lit(Scene2{}, 1, 2), {{0, 0}, {1, 1}, 3, 2}).grid.values, Each(2.0));
}

TEST(AverageIllumination2, StaysBetweenBlackAndTheBrightestFace) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const Lit lit(random_lattice_scene(seed, 30));
    for (const double value : averages(lit, {{-1, -1}, {9, 9}, 20, 20}).grid.values) {
      EXPECT_GE(value, 0.0);
      EXPECT_LT(value, 10.0);
    }
  }
}

TEST(AverageIllumination2, DoesNotChangeWhenSceneAndGridAreMovedAndScaled) {
  const Rational far("9007199254740993"), tiny(Integer(1), Integer(1) << 40);  // 2^53 + 1, 2^-40
  for (Scene2 scene : {clutter(30), random_lattice_scene(4, 20)}) {
    scene.closed = false;  // cells outside have light too
    const Grid2 cells{{Rational(1, 3), Rational(1, 7)}, {7, 8}, 14, 11};
    const AverageIllumination2 plain = averages(Lit(scene, 2), cells);
    EXPECT_LT(plain.max_error, 1e-10);
    for (const auto& map : {std::pair<Rational, Rational>{1, far}, {tiny, 0}, {tiny, far}}) {
      const Rational &scale = map.first, &offset = map.second;
      Scene2 moved = scene;
      Grid2 there = cells;
      const auto move = [&](Point2& p) { p = {p.x * scale + offset, p.y * scale - 2 * offset}; };
      for (Edge2& surface : moved.edges) {
        move(surface.from);
        move(surface.to);
      }
      move(there.min);
      move(there.max);
      // The vertices may be numbered otherwise, so that sums are in another order.
      const AverageIllumination2 light = averages(Lit(moved, 2), there);
      EXPECT_NEAR(light.max_error, plain.max_error, 1e-3 * plain.max_error);
      for (std::size_t k = 0; k < light.grid.values.size(); ++k)
        EXPECT_NEAR(light.grid.values[k], plain.grid.values[k], 2 * plain.errors[k / 2]);
    }
  }
}

// Cells a millionth of a room wide: what they show is the light at that point, and the bound does not suffer.
TEST(AverageIllumination2, StaysSharpInGridsMuchSmallerThanTheScene) {
  const Lit lit(pillar_room());
  const Rational tiny(1, 10000000), x(1, 3), y(1, 7);
  const AverageIllumination2 light = averages(lit, {{x, y}, {x + tiny, y + tiny}, 10, 10});
  EXPECT_LT(light.max_error, 1e-11);
  EXPECT_NEAR(light.grid.values[0], lit.reference({x, y}), 1e-5);
  const Rational d = tiny / 20;
  EXPECT_NEAR(light.grid.values[0], lit.reference({x + d, y + d}), 1e-12);
}

// A speck that no double can tell from a point, and one whose ends two doubles could not.
TEST(AverageIllumination2, DoesNotMindSpecks) {
  for (const unsigned long bits : {60ul, 150ul, 400ul}) {
    const Rational speck(Integer(1), Integer(1) << bits), half(1, 2);
    Scene2 scene = square_room();
    add_edge(scene, {half, half}, {half + speck, half + speck / 3}, true);
    const Lit lit(scene, 1, 1);
    const AverageIllumination2 light = averages(lit, {{0, 0}, {1, 1}, 5, 5});
    EXPECT_LT(light.max_error, 1e-11);
    for (std::size_t k = 0; k < light.errors.size(); ++k) EXPECT_NEAR(light.grid.values[k], 1, light.errors[k]);
  }
}

// Cells so small that two doubles cannot place the scene among them: the bound owns up to it.
TEST(AverageIllumination2, OwnsUpToWhatItCannotPlace) {
  const Lit lit(pillar_room(), 1, 1);
  const Rational tiny(Integer(1), Integer(1) << 120), x(1, 3);
  const AverageIllumination2 light = averages(lit, {{x, x}, {x + tiny, x + tiny}, 4, 4});
  EXPECT_EQ(light.max_error, 1.0);
  for (const double value : light.grid.values) EXPECT_NEAR(value, 1, light.max_error);
}

TEST(AverageIllumination2, TakesCellsOfAnyShape) {
  const Lit lit(random_lattice_scene(2, 14));
  const AverageIllumination2 square = averages(lit, {{0, 0}, {8, 8}, 64, 64});
  for (const auto& [nx, ny] : {std::pair<std::uint32_t, std::uint32_t>{1, 64}, {64, 1}, {2, 32}}) {
    const AverageIllumination2 light = averages(lit, {{0, 0}, {8, 8}, nx, ny});
    for (std::uint32_t iy = 0; iy < ny; ++iy)
      for (std::uint32_t ix = 0; ix < nx; ++ix) {
        double mean = 0;
        const std::uint32_t w = 64 / nx, h = 64 / ny;
        for (std::uint32_t k = 0; k < w * h; ++k) mean += square.grid.at(ix * w + k % w, iy * h + k / w) / (w * h);
        EXPECT_NEAR(light.grid.at(ix, iy), mean, light.max_error + square.max_error);
      }
  }
}

TEST(AverageIllumination2, DoesNotDependOnTheThreads) {
  const Lit lit(clutter(60), 3);
  const Grid2 cells = default_grid(lit.prepared.scene, 75);
  const AverageIllumination2 once = averages(lit, cells);
  for (const int threads : {1, 2, 3, 7}) {
    const ThreadLimit limit(threads);
    const AverageIllumination2 again = averages(lit, cells);
    EXPECT_EQ(again.grid.values, once.grid.values) << threads;
    EXPECT_EQ(again.errors, once.errors) << threads;
  }
}

TEST(AverageIllumination2, ReportsProgressAndStops) {
  const Lit lit(clutter(40));
  const Grid2 cells{{0, 0}, {1, 1}, 16, 16};
  std::vector<double> reports;
  illuminate_averages(lit.prepared, cells, lit.faces(), [&](double f) { reports.push_back(f); });
  EXPECT_GE(reports.size(), 3u);
  EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
  EXPECT_EQ(reports.back(), 1.0);
  EXPECT_THROW(illuminate_averages(lit.prepared, cells, lit.faces(), [](double) { throw 1; }), int);
  request_interrupt();
  EXPECT_THROW(averages(lit, cells), Interrupted);
  interrupt_flag = false;
}

}  // namespace
}  // namespace hottel::illumination_average_test

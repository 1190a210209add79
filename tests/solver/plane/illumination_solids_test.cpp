#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "geometry/plane/visibility/solid_around.h"
#include "solver/plane/light/average_illumination.h"
#include "solver/plane/light/cell_views.h"
#include "tests/solver/plane/solid_scenes.h"

namespace hottel::illumination_solids_test {
namespace {

using testing::Each;

constexpr double kB = 0.7;
const Rational kHalf(1, 2), kEighth(1, 8);

// Centres are the multiples of 1/4 from the corner (0, 0): on borders, in corners, on common walls.
const Grid2 kQuarters{{-kEighth, -kEighth}, {4 + kEighth, 3 + kEighth}, 17, 13};
// No centre is on any border.
const Grid2 kBetween{{0, 0}, {4, 3}, 23, 19};

TEST(IlluminationInSolids, OfARoomOfOneTemperatureIsTheRoomsEverywhereElse) {
  for (const BoxRoom& room : box_rooms()) {
    const Lit lit(room.scene, 2, kB);
    std::size_t solid = 0, free = 0;
    for (const Grid2& cells : {kQuarters, kBetween}) {
      const IlluminationGrid2 grid = lit.grid(cells);
      for (std::uint32_t iy = 0; iy < cells.ny; ++iy)
        for (std::uint32_t ix = 0; ix < cells.nx; ++ix) {
          const Point2 eye = cell_centre(cells, ix, iy);
          const bool is_solid = room.is_in_solid(eye);
          for (std::uint32_t c = 0; c < 2; ++c) {
            ASSERT_EQ(std::isnan(grid.at(ix, iy, c)), is_solid) << room.name << " " << eye.x << " " << eye.y;
            if (!is_solid && BoxRoom::is_within_walls(eye)) {
              ASSERT_NEAR(grid.at(ix, iy, c), kB, 2e-15) << room.name << " " << eye.x << " " << eye.y;
            }
          }
          ++(is_solid ? solid : free);
        }
    }
    EXPECT_GT(solid, 10u) << room.name;
    EXPECT_GT(free, 100u) << room.name;
  }
}

TEST(IlluminationInSolids, IsNaNForTheInverseSquareFormulaAtTheSamePoints) {
  for (BoxRoom room : box_rooms()) {
    room.scene.closed = false;  // of closed scenes: closed_light_test
    const Lit lit(room.scene);
    for (const Grid2& cells : {kQuarters, kBetween}) {
      const IlluminationGrid2 points = lit.grid(cells),
                              grid = illuminate_inverse_square(lit.prepared, cells, lit.table, lit.by_element, 1);
      for (std::size_t k = 0; k < grid.values.size(); ++k)
        ASSERT_EQ(std::isnan(grid.values[k]), std::isnan(points.values[k])) << room.name << " " << k;
    }
  }
}

TEST(IlluminationInSolids, OnTheBorderIsTheLimitFromTheFreeSide) {
  const Rational tiny(1, 1ul << 62);
  BoxRoom room("box");
  room.box({1, 0, 2, 1});
  const Lit lit(room.scene);
  const Rational x(5, 3), y(1, 3);
  EXPECT_NEAR(lit.at(x, 1), lit.reference({x, 1 + tiny}), 1e-13);
  EXPECT_NEAR(lit.at(1, y), lit.reference({1 - tiny, y}), 1e-13);
  EXPECT_NEAR(lit.at(2, y), lit.reference({2 + tiny, y}), 1e-13);
}

// At the corners of boxes: the mean over the directions of approach that are free.
TEST(IlluminationInSolids, AtACornerIsTheMeanOverTheFreeDirectionsOfApproach) {
  const Rational tiny(1, 1ul << 62);
  for (const BoxRoom& room : box_rooms()) {
    const Lit lit(room.scene);
    for (const Box2& box : room.boxes)
      for (const Point2& at : {Point2{box.x0, box.y0}, {box.x1, box.y1}, {box.x1, box.y0}}) {
        if (room.is_in_solid(at)) continue;
        constexpr int kDirections = 400;
        double sum = 0;
        int free = 0;
        for (int k = 0; k < kDirections; ++k) {
          const double phi = 2 * std::numbers::pi * (k + 0.37) / kDirections;
          const Point2 eye{at.x + Rational(std::cos(phi)) * tiny, at.y + Rational(std::sin(phi)) * tiny};
          if (room.is_in_solid(eye)) continue;
          sum += lit.reference(eye);
          ++free;
        }
        EXPECT_NEAR(lit.at(at.x, at.y), sum / free, 0.06) << room.name;  // jumps: an error of one direction in 100
      }
  }
}

TEST(IlluminationInSolids, WithoutSolidsIsANumberEverywhere) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const Lit lit(random_lattice_scene(seed, 30));
    const Grid2 cells{{Rational(-1, 4), Rational(-1, 4)}, {Rational(35, 4), Rational(35, 4)}, 18, 18};
    for (const double value : lit.grid(cells).values) EXPECT_GE(value, 0.0);
    for (const double value : illuminate_averages(lit.prepared, cells, lit.faces()).grid.values) EXPECT_GE(value, 0.0);
  }
}

TEST(SolidAround, NamesTheGroupThatMakesItSolid) {
  BoxRoom room("two");
  room.box({1, 0, 2, 1}).box({2, 0, 3, 1});
  const Lit lit(room.scene);
  const auto around = [&](const Rational& x, const Rational& y) {
    View2 view;
    lit.location.look_around(
        Eye2(lit.prepared.arrangement.vertices(), lit.prepared.arrangement.vertices().from_scene(Point2{x, y})), view);
    return solid_around(lit.prepared.arrangement, view);
  };
  EXPECT_EQ(around(1 + kHalf, kHalf), 1u);
  EXPECT_EQ(around(2 + kHalf, kHalf), 2u);
  EXPECT_THAT(around(2, kHalf), testing::AnyOf(1u, 2u));
  for (const Rational& x : {Rational(1), Rational(2), Rational(3), Rational(4), Rational(7, 2), Rational(9)}) {
    EXPECT_EQ(around(x, 1), Solids2::kNone);
    EXPECT_EQ(around(x, 0), Solids2::kNone);
  }
}

TEST(AverageInSolids, OfARoomOfOneTemperatureIsTheRoomsInEveryCellThatIsNotWhollySolid) {
  // Cells whose borders are those of boxes, and cells that boxes cut.
  const std::vector<Grid2> grids{{{0, 0}, {4, 3}, 16, 12}, {{0, 0}, {4, 3}, 6, 9}, {{0, 0}, {4, 3}, 37, 29}};
  for (const BoxRoom& room : box_rooms()) {
    const Lit lit(room.scene, 2, kB);
    std::size_t solid = 0;
    for (const Grid2& cells : grids) {
      const AverageIllumination2 light = illuminate_averages(lit.prepared, cells, lit.faces());
      const Rational w = Rational(4) / Rational(cells.nx), h = Rational(3) / Rational(cells.ny);
      for (std::uint32_t iy = 0; iy < cells.ny; ++iy)
        for (std::uint32_t ix = 0; ix < cells.nx; ++ix) {
          const Box2 cell{w * ix, h * iy, w * (ix + 1), h * (iy + 1)};
          const bool is_share_known = cells.nx != 37;
          const double value = light.grid.at(ix, iy), error = light.errors[std::size_t{iy} * cells.nx + ix];
          if (is_share_known) {
            ASSERT_EQ(std::isnan(value), free_share(room, cell.x0, cell.y0, cell.x1, cell.y1) == 0)
                << room.name << " " << ix << " " << iy;
          }
          ASSERT_EQ(std::isnan(value), std::isnan(light.grid.at(ix, iy, 1)));
          solid += std::isnan(value) ? 1 : 0;
          if (std::isnan(value)) {
            EXPECT_EQ(error, 0);
            continue;
          }
          ASSERT_NEAR(value, kB, error) << room.name << " " << ix << " " << iy;
          ASSERT_LT(error, 1e-10) << room.name << " " << ix << " " << iy;
        }
      EXPECT_LT(light.max_error, 1e-10);
    }
    EXPECT_GT(solid, 8u) << room.name;
  }
}

// Of a cell only a sliver is free: its width over the bound is what remains to be known.
TEST(AverageInSolids, OwnsUpToWhatSliversDoNotTell) {
  for (const int bits : {10, 20, 30, 40, 60, 200, 2000}) {
    BoxRoom room("sliver");
    const Rational sliver(Integer(1), Integer(1) << bits);
    room.box({1, 0, 2 - sliver, 1});
    const Lit lit(room.scene, 1, kB);
    const Grid2 cells{{0, 0}, {4, 3}, 4, 3};
    const AverageIllumination2 light = illuminate_averages(lit.prepared, cells, lit.faces());
    EXPECT_NEAR(light.grid.at(1, 0), kB, light.errors[1]);
    EXPECT_FALSE(std::isnan(light.grid.at(1, 0))) << bits;
    EXPECT_LE(light.errors[1], bits < 50 ? 1e-11 * std::ldexp(1.0, bits) : kB) << bits;
    EXPECT_EQ(light.max_error, light.errors[1]);
    EXPECT_NEAR(light.grid.at(2, 0), kB, 1e-11);
  }
}

TEST(AverageInSolids, IsDefinedInGridsMuchSmallerAndLargerThanTheScene) {
  BoxRoom room("box");
  room.box({1, 0, 2, 1});
  room.scene.closed = false;  // so that there is an outside
  const Lit lit(room.scene, 1, kB);
  const Rational tiny(Integer(1), Integer(1) << 40), huge(Integer(1) << 60);
  const Grid2 small{{2 - 4 * tiny, kHalf}, {2 + 4 * tiny, kHalf + 8 * tiny}, 8, 8};  // the right wall is in its middle
  const AverageIllumination2 near = illuminate_averages(lit.prepared, small, lit.faces());
  for (std::uint32_t k = 0; k < 64; ++k) {
    ASSERT_EQ(std::isnan(near.grid.values[k]), k % 8 < 4) << k;
    if (k % 8 < 4) continue;
    EXPECT_NEAR(near.grid.values[k], kB, near.errors[k]);
  }
  const Grid2 large{{-huge, -huge}, {huge, huge}, 4, 4};
  for (const double value : illuminate_averages(lit.prepared, large, lit.faces()).grid.values)
    EXPECT_NEAR(value, kB, 1e-12);
}

TEST(AverageInSolids, IsTheLimitOfDenseGridsOfPoints) {
  for (const BoxRoom& room : box_rooms()) {
    const Lit lit(room.scene);
    const Grid2 cells{{0, 0}, {4, 3}, 5, 5};
    const AverageIllumination2 average = illuminate_averages(lit.prepared, cells, lit.faces());
    constexpr std::uint32_t kFine = 40;
    const IlluminationGrid2 points = lit.grid({cells.min, cells.max, 5 * kFine, 5 * kFine});
    for (std::uint32_t cell = 0; cell < 25; ++cell) {
      double sum = 0;
      int free = 0;
      for (std::uint32_t k = 0; k < kFine * kFine; ++k) {
        const double value = points.at(cell % 5 * kFine + k % kFine, cell / 5 * kFine + k / kFine);
        if (std::isnan(value)) continue;
        sum += value;
        ++free;
      }
      ASSERT_EQ(free == 0, std::isnan(average.grid.values[cell])) << room.name;
      if (free == 0) continue;
      EXPECT_NEAR(average.grid.values[cell], sum / free, 0.2) << room.name << " " << cell;
    }
  }
}

}  // namespace
}  // namespace hottel::illumination_solids_test

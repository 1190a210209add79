// Rows of what a point sees, against the exact visibility polygon, and the light that is made of them.
#include "solver/plane/light/light_rows.h"

#include <gmock/gmock.h>

#include <bit>
#include <cmath>
#include <map>
#include <mutex>

#include "geometry/plane/generate/generators.h"
#include "geometry/plane/visibility/solid_around.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "solver/plane/light/cell_views.h"
#include "tests/solver/plane/solid_scenes.h"

namespace hottel::light_rows_test {
namespace {

using testing::HasSubstr;

constexpr std::uint64_t kPlenty = std::uint64_t{1} << 40;
const Rational kTiny(1, 1ul << 62);

Scene2 generated(const char* kind, int n, unsigned seed) {
  GeneratorRequest2 request;
  request.kind = kind;
  request.n = n;
  request.seed = seed;
  return generate_2(request);
}

std::vector<Scene2> scenes() {
  std::vector<Scene2> result{pillar_room(), square_room(), generated("room", 40, 3), generated("clutter", 60, 2)};
  for (unsigned seed = 1; seed <= 10; ++seed)
    result.push_back(random_lattice_scene(seed, 4 + 2 * static_cast<int>(seed)));
  for (const BoxRoom& room : box_rooms()) result.push_back(room.scene);
  Scene2 divided = pillar_room();
  divided.surfaces[1].elements = 5;
  result.push_back(divided);
  return result;
}

// A grid over the scene and beyond; of lattice scenes some centres are on edges and vertices.
Grid2 cells_around(const Scene2& scene, std::uint32_t longer) {
  Grid2 cells = default_grid(scene, longer);
  const Rational margin = (cells.max.x - cells.min.x) / Rational(Integer(longer));
  cells.min.x -= margin;
  cells.max.y += margin;
  ++cells.nx;
  ++cells.ny;
  return cells;
}

using ByColumn = std::map<std::uint32_t, double>;

ByColumn by_column(const LightRow2& row) {
  ByColumn result;
  for (std::size_t k = 0; k < row.columns.size(); ++k) result[row.columns[k]] += row.fractions[k];
  return result;
}

LightRows2 rows_of(const Lit& lit, const Grid2& cells, Blacks2 blacks = Blacks2::kListed) {
  return {lit.prepared, cells, lit.table, blacks, kPlenty};
}

ByColumn row_at(const Lit& lit, const Rational& x, const Rational& y) {
  return by_column(rows_of(lit, {{x - 1, y - 1}, {x + 1, y + 1}, 1, 1}).row(0));
}

// The slow way: the exact visibility polygon, the angles of each element's parts summed and rounded once.
ByColumn exact_row(const Lit& lit, const Point2& eye) {
  const VisibilityPolygon2 polygon = visibility_polygon(lit.prepared.arrangement, lit.location, eye);
  std::map<std::uint32_t, std::vector<std::size_t>> parts;
  for (std::size_t k = 0; k < polygon.parts.size(); ++k) parts[lit.table.of(polygon.parts[k].side)].push_back(k);
  parts.erase(lit.table.covered());
  ByColumn result;
  for (const auto& [column, numbers] : parts) result[column] = rounded_angle_fraction(polygon, numbers).value;
  return result;
}

void expect_near(const ByColumn& row, const ByColumn& exact, double error, const std::string& what) {
  ASSERT_EQ(row.size(), exact.size()) << what;
  for (const auto& [column, fraction] : exact) {
    ASSERT_TRUE(row.contains(column)) << what;
    ASSERT_NEAR(row.at(column), fraction, error) << what << " column " << column;
  }
}

std::string at_text(const Point2& p) { return to_string(p.x) + " " + to_string(p.y); }

TEST(LightRow, HasTheExactFractionOfEachElementThatIsSeen) {
  std::size_t open = 0, solid = 0;
  for (const Scene2& scene : scenes()) {
    const Lit lit(scene);
    const Grid2 cells = cells_around(scene, 12);
    const LightRows2 rows = rows_of(lit, cells);
    for (std::size_t cell = 0; cell < rows.cells(); ++cell) {
      const Point2 eye =
          cell_centre(cells, static_cast<std::uint32_t>(cell % cells.nx), static_cast<std::uint32_t>(cell / cells.nx));
      const VisibilityPolygon2 polygon = visibility_polygon(lit.prepared.arrangement, lit.location, eye);
      ASSERT_EQ(rows.row(cell).is_in_solid, polygon.solid != Solids2::kNone);
      const auto kind = polygon.location.kind;
      if (rows.row(cell).is_in_solid) {
        ASSERT_TRUE(rows.row(cell).columns.empty());
        ++solid;
      } else if (kind == Location2::Kind::kInTriangle || kind == Location2::Kind::kOutside) {
        ASSERT_NO_FATAL_FAILURE(expect_near(by_column(rows.row(cell)), exact_row(lit, eye), 1e-14, at_text(eye)));
        ++open;
      }
    }
  }
  EXPECT_GT(open, 2000u);
  EXPECT_GT(solid, 20u);
}

TEST(LightRow, OnAnEdgeIsTheMeanOfThoseFromItsFreeSides) {
  std::size_t found = 0, beside_solids = 0;
  for (const Scene2& scene : scenes()) {
    const Lit lit(scene);
    const Vertices2& vertices = lit.prepared.arrangement.vertices();
    std::size_t number = 0;
    for (const Segment2& piece : lit.prepared.arrangement.pieces()) {
      if (++number > 20) break;
      const Point2 a = vertices.to_scene(vertices.exact(piece.a)), b = vertices.to_scene(vertices.exact(piece.b));
      const Point2 middle{(2 * a.x + b.x) / 3, (2 * a.y + b.y) / 3};
      ByColumn mean;
      std::vector<ByColumn> sides;
      for (const int side : {-1, 1}) {
        const Point2 beside{middle.x + side * (a.y - b.y) * kTiny, middle.y + side * (b.x - a.x) * kTiny};
        ByColumn row = exact_row(lit, beside);
        if (!row.empty()) sides.push_back(std::move(row));
      }
      for (const ByColumn& side : sides)
        for (const auto& [column, fraction] : side) mean[column] += fraction / static_cast<double>(sides.size());
      ByColumn row = row_at(lit, middle.x, middle.y);
      // What is seen from beside under next to nothing is not seen from the edge itself.
      std::erase_if(mean, [&](const auto& entry) { return entry.second < 1e-15 && !row.contains(entry.first); });
      ASSERT_NO_FATAL_FAILURE(expect_near(row, mean, 1e-12, at_text(middle)));
      ++found;
      beside_solids += sides.size() == 1 ? 1 : 0;
    }
  }
  EXPECT_GT(found, 200u);
  EXPECT_GT(beside_solids, 20u);
}

TEST(LightRow, SumsToOneEverywhereButInSolids) {
  double largest = 0;
  for (const Scene2& scene : scenes()) {
    const Lit lit(scene);
    std::mutex mutex;
    for (const std::uint32_t longer : {16u, 25u})
      for_each_light_row(lit.prepared, cells_around(scene, longer), lit.table, Blacks2::kListed, {},
                         [&](std::size_t, const LightRow2& row) {
                           double sum = 0;
                           for (const double fraction : row.fractions) {
                             EXPECT_GE(fraction, 0);
                             sum += fraction;
                           }
                           const std::lock_guard lock(mutex);
                           if (row.is_in_solid)
                             EXPECT_EQ(sum, 0);
                           else
                             largest = std::max(largest, std::fabs(sum - 1));
                         });
  }
  EXPECT_LE(largest, 2e-15);
}

TEST(LightRow, SumsToOneInAClosedRoom) {
  const Lit lit(generated("room", 40, 3));
  const LightRows2 rows = rows_of(lit, default_grid(lit.prepared.scene, 40));
  for (std::size_t cell = 0; cell < rows.cells(); ++cell) {
    double sum = 0;
    for (const double fraction : rows.row(cell).fractions) sum += fraction;
    if (rows.row(cell).is_in_solid) continue;
    ASSERT_NEAR(sum, 1, 1e-15);
  }
}

TEST(LightRow, OfAGridWithinASolidIsEmptyEverywhere) {
  const ThreadLimit limit(1);
  BoxRoom room("box");
  room.box({1, 1, 2, 2});
  const Lit lit(room.scene);
  const Grid2 cells{{1, 1}, {2, 2}, 3, 3};
  const LightRows2 rows = rows_of(lit, cells);
  for (std::size_t cell = 0; cell < 9; ++cell) EXPECT_TRUE(rows.row(cell).is_in_solid);
  LightRowFinder2 finder;  // that has found nothing before
  finder.begin(lit.prepared.arrangement.vertices(), LightColumns2(lit.prepared.arrangement, lit.table),
               Blacks2::kListed);
  finder.measure();
  EXPECT_EQ(finder.size(), 0u);
  for (const double value : lit.grid(cells).values) EXPECT_TRUE(std::isnan(value));
}

TEST(LightRow, WithoutWhatIsBlackHasTheSameOtherEntries) {
  std::size_t blacks = 0;
  for (const Scene2& scene : scenes()) {
    const Lit lit(scene, 3);
    const Grid2 cells = cells_around(scene, 16);
    const LightRows2 listed = rows_of(lit, cells), left_out = rows_of(lit, cells, Blacks2::kLeftOut);
    for (std::size_t cell = 0; cell < listed.cells(); ++cell) {
      const LightRow2 all = listed.row(cell), some = left_out.row(cell);
      ASSERT_EQ(all.sees_black, some.sees_black);
      ASSERT_EQ(all.is_in_solid, some.is_in_solid);
      std::size_t next = 0;
      bool sees_black = false;
      for (std::size_t k = 0; k < all.columns.size(); ++k) {
        const bool is_black = all.columns[k] != lit.table.sky() && !lit.table.elements()[all.columns[k]].material;
        sees_black = sees_black || is_black;
        blacks += is_black ? 1 : 0;
        if (is_black) continue;
        ASSERT_LT(next, some.columns.size());
        ASSERT_EQ(some.columns[next], all.columns[k]);
        ASSERT_EQ(some.fractions[next++], all.fractions[k]);
      }
      ASSERT_EQ(next, some.columns.size());
      ASSERT_EQ(sees_black, all.sees_black);
    }
    const auto bits = [](const IlluminationGrid2& grid) {
      std::vector<std::uint64_t> result;
      for (const double value : grid.values) result.push_back(std::bit_cast<std::uint64_t>(value));
      return result;
    };
    EXPECT_EQ(bits(illuminate_points(listed, cells, lit.sent_out())),
              bits(illuminate_points(left_out, cells, lit.sent_out())));
  }
  EXPECT_GT(blacks, 1000u);
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(
      a, b, {}, [](double x) { return std::bit_cast<std::uint64_t>(x); },
      [](double x) { return std::bit_cast<std::uint64_t>(x); });
}

TEST(LightRows2, GiveTheLightOfAnySolutionWithoutALook) {
  for (const Scene2& scene : scenes()) {
    Lit lit(scene, 3);
    const Grid2 cells = cells_around(scene, 20);
    const LightRows2 rows = rows_of(lit, cells, Blacks2::kLeftOut);
    for (const double factor : {1.0, 0.3}) {
      for (double& value : lit.by_element) value *= factor;
      EXPECT_TRUE(same_bits(illuminate_points(rows, cells, lit.sent_out()).values, lit.grid(cells).values));
    }
  }
}

TEST(LightRows2, ServeSeveralSolutionsAtOnceAsEachAlone) {
  for (const Scene2& scene : scenes()) {
    const Lit lit(scene, 3), gray(scene, 1), two(scene, 2), five(scene, 5);
    const SentOut2 solutions[] = {lit.sent_out(), gray.sent_out(), two.sent_out(), five.sent_out()};
    const Grid2 cells = cells_around(scene, 14);
    const std::vector<IlluminationGrid2> all = illuminate_points(lit.prepared, cells, lit.table, solutions);
    ASSERT_EQ(all.size(), 4u);
    EXPECT_TRUE(same_bits(all[0].values, lit.grid(cells).values));
    EXPECT_TRUE(same_bits(all[1].values, gray.grid(cells).values));
    EXPECT_TRUE(same_bits(all[2].values, two.grid(cells).values));
    EXPECT_TRUE(same_bits(all[3].values, five.grid(cells).values));
  }
}

TEST(LightRows2, AreTheSameForAnyNumberOfThreads) {
  const Lit lit(generated("clutter", 60, 2), 3);
  const Grid2 cells = cells_around(lit.prepared.scene, 150);
  const LightRows2 once = rows_of(lit, cells);
  for (const int threads : {1, 2, 3, 7}) {
    const ThreadLimit limit(threads);
    const LightRows2 again = rows_of(lit, cells);
    ASSERT_EQ(again.cells(), once.cells());
    for (std::size_t cell = 0; cell < once.cells(); ++cell) {
      ASSERT_TRUE(std::ranges::equal(once.row(cell).columns, again.row(cell).columns));
      ASSERT_TRUE(std::ranges::equal(once.row(cell).fractions, again.row(cell).fractions));
    }
  }
}

TEST(LightRows2, ComeInBandsThatHaveEachCellOnceInOrder) {
  const Lit lit(pillar_room());
  for (const Grid2& cells : {Grid2{{0, 0}, {1, 1}, 1, 1}, Grid2{{0, 0}, {1, 1}, 9, 300}, Grid2{{0, 0}, {1, 1}, 300, 9},
                             Grid2{{0, 0}, {1, 1}, 1100, 17}}) {
    const LightRows2 rows = rows_of(lit, cells);
    std::size_t next = 0;
    double reported = 0;
    for_each_light_band(
        lit.prepared, cells, lit.table, Blacks2::kListed, kPlenty, [&](double done) { reported = done; },
        [&](std::size_t first, const LightRowBlock2& block) {
          ASSERT_EQ(first, next);
          for (std::size_t k = 0; k < block.size(); ++k) {
            ASSERT_TRUE(std::ranges::equal(block.row(k).columns, rows.row(next).columns));
            ASSERT_TRUE(std::ranges::equal(block.row(k).fractions, rows.row(next).fractions));
            ++next;
          }
        });
    EXPECT_EQ(next, std::size_t{cells.nx} * cells.ny);
    EXPECT_EQ(reported, 1);
  }
}

TEST(LightRows2, AreRefusedWhenTheyTakeMoreMemoryThanIsAllowed) {
  const Lit lit(generated("clutter", 60, 2));
  const Grid2 cells = default_grid(lit.prepared.scene, 200);
  const std::uint64_t bytes = rows_of(lit, cells).bytes();
  for (const int threads : {1, 3}) {
    const ThreadLimit limit(threads);
    for (const std::uint64_t memory : {std::uint64_t{1}, bytes / 10, bytes / 2, bytes}) {
      try {
        const LightRows2 rows(lit.prepared, cells, lit.table, Blacks2::kListed, memory);
        ADD_FAILURE() << memory;
      } catch (const RequestError& error) {
        EXPECT_THAT(error.what(), HasSubstr("more than the " + std::to_string(memory) + " bytes of memory"));
        EXPECT_THAT(error.what(), HasSubstr("take a coarser grid"));
      }
    }
    EXPECT_EQ(LightRows2(lit.prepared, cells, lit.table, Blacks2::kListed, 2 * bytes).bytes(), bytes);
  }
}

// A radiosity whose sum over fractions that round is not itself.
TEST(SentOut2, IsExactlyBWhereEverythingSeenSendsOutB) {
  std::mt19937_64 random(7);
  for (const Scene2& scene : scenes()) {
    const double b = std::ldexp(static_cast<double>(random() >> 11), static_cast<int>(random() % 60) - 80);
    Lit lit(scene, 3, b);
    for (const bool is_black_seen : {false, true}) {
      const LightRows2 rows = rows_of(lit, cells_around(scene, 21));
      for (std::size_t cell = 0; cell < rows.cells(); ++cell) {
        const LightRow2 row = rows.row(cell);
        if (row.is_in_solid || row.sees_black != is_black_seen) continue;
        std::vector<double> light(3);
        lit.sent_out().light(row, light);
        for (const double value : light) {
          if (!is_black_seen) {
            ASSERT_EQ(value, b);
          }
          ASSERT_GE(value, 0);
          ASSERT_LE(value, b);
        }
      }
    }
  }
}

TEST(SentOut2, LightIsBetweenTheLeastAndTheLargestRadiositySeen) {
  std::mt19937_64 random(11);
  for (const Scene2& scene : scenes())
    for (const std::uint32_t channels : {1u, 3u}) {
      Lit lit(scene, channels);
      for (double& value : lit.by_element) {  // neighbouring doubles
        value = 0.1;
        for (auto steps = random() % 3; steps > 0; --steps) value = std::nextafter(value, 1);
      }
      lit.sky.assign(channels, 0.1);
      const SentOut2 sent_out = lit.sent_out();
      const LightRows2 rows = rows_of(lit, cells_around(scene, 15));
      for (std::size_t cell = 0; cell < rows.cells(); ++cell) {
        const LightRow2 row = rows.row(cell);
        if (row.is_in_solid) continue;
        std::vector<double> light(channels);
        sent_out.light(row, light);
        for (std::uint32_t c = 0; c < channels; ++c) {
          double least = HUGE_VAL, most = 0;
          for (const std::uint32_t column : row.columns) {
            least = std::min(least, sent_out.of(column, c));
            most = std::max(most, sent_out.of(column, c));
          }
          ASSERT_GE(light[c], least);
          ASSERT_LE(light[c], most);
        }
      }
    }
}

TEST(SentOut2, IsZeroExactlyWhereOnlyWhatIsBlackIsSeenAndNaNInSolids) {
  for (const Scene2& scene : scenes()) {
    Lit lit(scene, 2, 3);
    lit.sky = {0, 0};
    const Grid2 cells = cells_around(scene, 19);
    const LightRows2 rows = rows_of(lit, cells);
    const IlluminationGrid2 light = lit.grid(cells);
    for (std::size_t cell = 0; cell < rows.cells(); ++cell) {
      const LightRow2 row = rows.row(cell);
      const bool sees_light = std::ranges::any_of(row.columns, [&](std::uint32_t column) {
        return column != lit.table.sky() && lit.table.elements()[column].material.has_value();
      });
      for (std::size_t c = 0; c < 2; ++c) {
        const double value = light.values[2 * cell + c];
        ASSERT_EQ(std::isnan(value), row.is_in_solid);
        if (!row.is_in_solid) {
          ASSERT_EQ(value > 0, sees_light);
        }
      }
    }
  }
}

TEST(SentOut2, TakesNothingButOneValueForEachElementAndChannel) {
  const Lit lit(pillar_room());
  EXPECT_THROW(SentOut2(lit.table, lit.by_element, {}), ContractViolation);
  EXPECT_THROW(SentOut2(lit.table, std::span(lit.by_element).subspan(1), lit.sky), ContractViolation);
  const LightRows2 rows = rows_of(lit, {{0, 0}, {1, 1}, 3, 3});
  EXPECT_THROW(illuminate_points(rows, Grid2{{0, 0}, {1, 1}, 3, 4}, lit.sent_out()), ContractViolation);
}

}  // namespace
}  // namespace hottel::light_rows_test

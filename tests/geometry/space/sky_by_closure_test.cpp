// The sky as what all others leave: against its integrals, and what is done where that does not tell it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "geometry/space/exchange/exchange.h"
#include "geometry/space/exchange/exchange_rows.h"
#include "geometry/space/exchange/rest_for_sky.h"
#include "geometry/space/scene/division.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "tests/same_matrix.h"

namespace hottel::sky_by_closure_test {
namespace {

ExchangeRequest request(SkyBy sky, double tolerance = 1e-9) {
  return {.granularity = Granularity::kElement, .wants_visibility = false, .tolerance = tolerance, .sky = sky};
}

Scene3 scene_of(const char* name, std::uint32_t elements = 1) {
  Scene3 scene = read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/" + name);
  divide_into(scene, elements);
  return scene;
}

// An open box, 2 x 2 elements a side, with a sheet in it that has a material on both of its sides.
Scene3 open_box() {
  Scene3 scene = parse_scene_3(R"({"hottel": 1, "dimension": 3, "materials": {"m": {"reflectivity": 0.5}}, "polygons": [
    {"name": "floor", "points": [[0,0,0],[2,0,0],[2,2,0],[0,2,0]], "material": "m"},
    {"name": "left", "points": [[0,0,0],[0,2,0],[0,2,1],[0,0,1]], "material": "m", "back": "m"},
    {"name": "right", "points": [[2,0,0],[2,0,1],[2,2,1],[2,2,0]], "material": "m", "back": "m"},
    {"name": "near", "points": [[0,0,0],[0,0,1],[2,0,1],[2,0,0]], "material": "m", "back": "m"},
    {"name": "far", "points": [[0,2,0],[2,2,0],[2,2,1],[0,2,1]], "material": "m"},
    {"name": "sheet", "points": [[0.5,0.5,0.5],[1.5,0.5,0.5],[1.5,1.5,0.625],[0.5,1.5,0.625]], "material": "m",
     "back": "m"}]})",
                               "open box");
  divide_into(scene, 2);
  return scene;
}

double sum_of(const FactorRow& row) {
  long double sum = 0;
  for (const FactorEntry& entry : row) sum += entry.factor.value;
  return static_cast<double>(sum);
}

// All others have the same bits, and so have rows that are checked; the sky of the others is that of its integral
// within what their pairs state, and rows sum to 1.
TEST(SkyByClosure, IsWhatTheOthersLeave) {
  for (const Scene3& scene : {open_box(), scene_of("city_block.json")}) {
    const PreparedScene3 prepared = prepare(scene);
    ExchangeReport3 of_integrals, of_rest;
    const ExchangeMatrix a = exact_exchange(prepared, request(SkyBy::kIntegral), &of_integrals);
    const ExchangeMatrix b = exact_exchange(prepared, request(SkyBy::kClosure), &of_rest);
    EXPECT_FALSE(of_integrals.sky);
    ASSERT_TRUE(of_rest.sky);
    const SkyByClosure& sky = *of_rest.sky;
    std::uint32_t rows = 0, checked = 0;
    ASSERT_EQ(a.entry_count(), b.entry_count());
    for (std::uint32_t i = 0; i < a.size(); ++i) {
      if (!a.has_row(i)) continue;
      const bool is_checked = rows++ % kRowsOfASkyCheck == 0;
      checked += is_checked;
      ASSERT_EQ(a.row(i).size(), b.row(i).size());
      for (std::size_t k = 0; k < a.row(i).size(); ++k) {
        const FactorEntry &x = a.row(i)[k], &y = b.row(i)[k];
        EXPECT_EQ(x.to, y.to);
        if (x.to != a.size() || is_checked) {
          EXPECT_EQ(x.factor, y.factor);
        } else {
          EXPECT_NEAR(x.factor.value, y.factor.value, sky.max_error + 1e-12);
          EXPECT_LE(b.bounds(i, k).lower, y.factor.value);
          EXPECT_GE(b.bounds(i, k).upper, y.factor.value);
        }
      }
      if (a.factor(i, a.size()) != b.factor(i, a.size())) {
        EXPECT_NEAR(sum_of(b.row(i)), 1, 1e-15);
      }
    }
    EXPECT_EQ(sky.checked, checked);
    EXPECT_EQ(sky.told + sky.checked + sky.integrated, rows);
    EXPECT_GT(sky.told, rows / 2);
    EXPECT_EQ(sky.beyond, 0u);
    EXPECT_LE(sky.max_difference, 1e-12);
    EXPECT_LE(sky.max_error, sky.within);
    EXPECT_LT(of_rest.maps, of_integrals.maps);
  }
}

// Whether anything is seen of the sky is decided by signs.
TEST(SkyByClosure, IsNoneWhereNoneIsSeen) {
  const PreparedScene3 prepared = prepare(scene_of("two_boxes.json", 2));
  ExchangeReport3 report;
  const ExchangeMatrix matrix = exact_exchange(prepared, request(SkyBy::kClosure), &report);
  expect_same(matrix, exact_exchange(prepared, request(SkyBy::kIntegral)));
  EXPECT_EQ(report.sky->told, 0u);
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    if (matrix.has_row(i)) {
      EXPECT_LT(matrix.row(i).back().to, matrix.size());
    }
}

// Through a slit of a billionth: less than the others may be off.
TEST(SkyByClosure, IsIntegratedWhereItIsLessThanTheOthersMayBeOff) {
  const Scene3 scene = parse_scene_3(R"({"hottel": 1, "dimension": 3, "materials": {"m": {"reflectivity": 0.5}},
    "polygons": [
    {"name": "floor", "points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "material": "m"},
    {"name": "x0", "points": [[0,0,0],[0,1,0],[0,1,1],[0,0,1]], "material": "m"},
    {"name": "x1", "points": [[1,0,0],[1,0,1],[1,1,1],[1,1,0]], "material": "m"},
    {"name": "y0", "points": [[0,0,0],[0,0,1],[1,0,1],[1,0,0]], "material": "m"},
    {"name": "y1", "points": [[0,1,0],[1,1,0],[1,1,1],[0,1,1]], "material": "m"},
    {"name": "lid", "points": [[0,0,1],[0,1,1],[0.5,1,1],[0.5,0,1]], "material": "m"},
    {"name": "lid2", "points": [[0.500000001,0,1],[0.500000001,1,1],[1,1,1],[1,0,1]], "material": "m"}]})",
                                     "slit");
  const PreparedScene3 prepared = prepare(scene);
  ExchangeReport3 report;
  const ExchangeMatrix matrix = exact_exchange(prepared, request(SkyBy::kClosure), &report);
  expect_same(matrix, exact_exchange(prepared, request(SkyBy::kIntegral)));
  EXPECT_EQ(report.sky->told, 0u);
  EXPECT_EQ(report.sky->integrated, 6u);
  ASSERT_FALSE(matrix.row(0).empty());
  EXPECT_EQ(matrix.row(0).back().to, matrix.size());
  EXPECT_LT(matrix.row(0).back().factor.value, 1e-9);
}

// Rows in any order, with whatever was known before of them, by closure or not: the same bits.
TEST(SkyByClosure, DependsOnNoOrderAndNothingKnownBefore) {
  const PreparedScene3 prepared = prepare(open_box());
  const ExchangeMatrix by_closure = exact_exchange(prepared, request(SkyBy::kClosure));
  const ExchangeMatrix by_integral = exact_exchange(prepared, request(SkyBy::kIntegral));
  std::mt19937_64 random(3);
  for (const SkyBy first : {SkyBy::kClosure, SkyBy::kIntegral}) {
    ExchangeRows3 rows(prepared, request(first));
    std::vector<PairSum3> pairs;
    PairRanges known(rows.table().count());
    rows.hand_on(
        [&](std::span<const PairSum3> some, const PairRanges& ranges) {
          pairs.insert(pairs.end(), some.begin(), some.end());
          for (std::uint32_t i = 0; i < ranges.elements(); ++i)
            for (const ColumnRange& range : ranges.ranges(i)) {
              for (std::uint32_t j = range.begin; j < range.end; ++j)
                if (rows.table().has_row(i) || rows.table().has_row(j)) {
                  EXPECT_FALSE(known.has(i, j)) << i << ' ' << j;
                }
              known.add(i, range);
            }
        },
        std::chrono::seconds(0));
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < rows.table().count(); ++i)
      if (rows.is_missing(i)) order.push_back(i);
    std::ranges::shuffle(order, random);
    rows.add(std::span(order).subspan(0, 7));
    const std::vector<PairSum3> some = pairs;
    const PairRanges some_known = known;
    rows.add_all();
    expect_same(rows.matrix(), first == SkyBy::kClosure ? by_closure : by_integral);
    EXPECT_EQ(known.has_all(), first == SkyBy::kIntegral) << "what is not measured is not handed on";
    for (const SkyBy then : {SkyBy::kClosure, SkyBy::kIntegral}) {
      ExchangeRows3 whole(prepared, request(then)), part(prepared, request(then));
      whole.take(pairs, known);
      part.take(some, some_known);
      whole.add_all();
      part.add_all();
      expect_same(whole.matrix(), then == SkyBy::kClosure ? by_closure : by_integral);
      expect_same(part.matrix(), then == SkyBy::kClosure ? by_closure : by_integral);
    }
  }
}

class ASumThatIsOff : public testing::Test {
 protected:
  ASumThatIsOff()
      : prepared_(prepare(open_box())),
        table_(prepared_.scene, prepared_.arrangement(), prepared_.occluders(), Granularity::kElement) {
    sums_ = sum_of_all();
  }
  PairSums3 sum_of_all() const {
    ExchangeRows3 rows(prepared_, request(SkyBy::kIntegral));
    rows.add_all();
    return {{rows.pairs().begin(), rows.pairs().end()}, {}};
  }
  // Of the first row and another one that is not the sky.
  PairSum3& a_pair() {
    return *std::ranges::find_if(sums_.pairs, [&](const PairSum3& pair) {
      return pair.i == 0 && pair.j != table_.sky() && pair.measure > 0.01 * table_.extent(0).value;
    });
  }

  PreparedScene3 prepared_;
  ElementTable3 table_;
  PairSums3 sums_;
};

// As where a surface is missing everywhere.
TEST_F(ASumThatIsOff, IsRefusedByName) {
  a_pair().measure *= 0.99;
  try {
    take_sky_by_closure(table_, 1e-9, sums_);
    ADD_FAILURE();
  } catch (const RequestError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("the row of 'floor#0' leaves 0."));
    EXPECT_THAT(error.what(), testing::HasSubstr("they differ by"));
  }
}

TEST_F(ASumThatIsOff, IsToldWhereItIsOffByMoreThanItStates) {
  EXPECT_EQ(take_sky_by_closure(table_, 1e-9, sums_).beyond, 0u);
  sums_ = sum_of_all();
  for (PairSum3& pair : sums_.pairs) pair.error = 0;
  a_pair().measure += 2e-10 * table_.extent(0).value;
  const SkyByClosure told = take_sky_by_closure(table_, 1e-9, sums_);
  EXPECT_EQ(told.beyond, 1u);
  EXPECT_NEAR(told.max_difference, 2e-10, 1e-12);
  EXPECT_EQ(told.farthest, "floor#0");
}

// What could not be integrated is what is left all the same, where that is told.
TEST_F(ASumThatIsOff, NeedsNoIntegral) {
  const auto of_row_5 = [&](const PairSum3& pair) { return pair.i == 5 && pair.j == table_.sky(); };
  const PairSum3 integral = *std::ranges::find_if(sums_.pairs, of_row_5);
  std::erase_if(sums_.pairs, of_row_5);
  sums_.failures.push_back({5, table_.sky(), 1, false, "too hard"});
  take_sky_by_closure(table_, 1e-9, sums_);
  EXPECT_TRUE(sums_.failures.empty());
  const auto rest = std::ranges::find_if(sums_.pairs, of_row_5);
  ASSERT_NE(rest, sums_.pairs.end());
  EXPECT_NEAR(rest->measure, integral.measure, 1e-12 * table_.extent(5).value);
  EXPECT_TRUE(std::ranges::is_sorted(sums_.pairs, {}, [](const PairSum3& p) { return std::pair(p.i, p.j); }));
}

}  // namespace
}  // namespace hottel::sky_by_closure_test

// View factors in parts, in any order.
#include "geometry/space/exchange/exchange_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "geometry/space/exchange/exchange.h"
#include "geometry/space/scene/division.h"
#include "io/scene/scene_json.h"

namespace hottel::exchange_rows_test::exchange_rows_test {
namespace {

void expect_same(const ExchangeMatrix& a, const ExchangeMatrix& b) {
  ASSERT_EQ(a.entry_count(), b.entry_count());
  for (std::uint32_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a.row(i).size(), b.row(i).size());
    for (std::size_t k = 0; k < a.row(i).size(); ++k) {
      EXPECT_EQ(a.row(i)[k].to, b.row(i)[k].to);
      EXPECT_EQ(a.row(i)[k].factor, b.row(i)[k].factor);
      EXPECT_EQ(a.row(i)[k].visibility, b.row(i)[k].visibility);
      EXPECT_EQ(a.bounds(i, k).lower, b.bounds(i, k).lower);
      EXPECT_EQ(a.bounds(i, k).upper, b.bounds(i, k).upper);
      EXPECT_EQ(a.guarantee(i, k), b.guarantee(i, k));
    }
  }
}

// A box in the open before a wall with a mask, and one closed room.
std::vector<Scene3> scenes() {
  std::vector<Scene3> result{read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/two_boxes.json"),
                             parse_scene_3(R"({"hottel": 1, "dimension": 3, "materials": {"m": {"reflectivity": 0.5}},
    "polygons": [
    {"name": "wall", "points": [[0,0,0],[2,0,0],[2,2,0],[0,2,0]], "material": "m", "back": "m"},
    {"name": "mask", "points": [[0.5,0.5,0],[0.5,1,0],[1,1,0],[1,0.5,0]], "material": "m", "masks": "wall"},
    {"name": "lid", "points": [[0,0,1],[0,2,1],[2,2,1],[2,0,1]], "material": "m"},
    {"name": "fin", "points": [[1,0.2,0.2],[1,1.8,0.2],[1,1.8,0.8],[1,0.2,0.8]], "material": "m"}]})",
                                           "masked")};
  divide_into(result[0], 2);
  return result;
}

// (1) and (2)
TEST(ExchangeRows3, InAnyOrderAreTheMatrix) {
  std::mt19937_64 random(7);
  for (const Scene3& scene : scenes())
    for (const Granularity granularity : {Granularity::kElement, Granularity::kGroup}) {
      const PreparedScene3 prepared = prepare(scene);
      const ExchangeRequest request{.granularity = granularity};
      ExchangeReport3 expected_report, report;
      const ExchangeMatrix expected = exact_exchange(prepared, request, &expected_report);
      ExchangeRows3 rows(prepared, request);
      std::vector<std::uint32_t> order;
      for (std::uint32_t i = 0; i < rows.table().count(); ++i)
        if (rows.is_missing(i)) order.push_back(i);
      EXPECT_EQ(rows.missing(), order.size());
      std::ranges::shuffle(order, random);
      while (!order.empty()) {
        const std::size_t part = std::min<std::size_t>(order.size(), 1 + random() % 9);
        const std::vector<std::uint32_t> now(order.end() - static_cast<std::ptrdiff_t>(part), order.end());
        order.resize(order.size() - part);
        rows.add(now);
        for (const std::uint32_t i : now) EXPECT_FALSE(rows.is_missing(i));
        EXPECT_TRUE(rows.add(now).empty()) << "what has come is not measured again";
      }
      EXPECT_EQ(rows.missing(), 0u);
      expect_same(rows.matrix(&report), expected);
      EXPECT_EQ(report.hidden, expected_report.hidden);
      EXPECT_EQ(report.clear, expected_report.clear);
      EXPECT_EQ(report.mixed, expected_report.mixed);
      EXPECT_EQ(report.pairs, expected_report.pairs);
    }
}

// (1): every pair of a row is there when it has come, with its factor.
TEST(ExchangeRows3, ARowThatHasComeIsWhole) {
  const PreparedScene3 prepared = prepare(scenes()[0]);
  const ExchangeRequest request{.granularity = Granularity::kElement};
  const ExchangeMatrix matrix = exact_exchange(prepared, request);
  ExchangeRows3 rows(prepared, request);
  const std::vector<std::uint32_t> first{5}, second{9};
  rows.add(first);
  std::size_t found = 0;
  for (const PairSum3& pair : rows.add(second)) {
    EXPECT_TRUE(pair.i == 9 || pair.j == 9);
    EXPECT_FALSE(pair.i == 5 || pair.j == 5);
    if (pair.is_zero()) continue;
    const std::uint32_t to = pair.i == 9 ? pair.j : pair.i;
    EXPECT_EQ(rows.factor(pair, 9), matrix.factor(9, to).value);
    ++found;
  }
  EXPECT_EQ(found + (matrix.factor(9, 5).value > 0 ? 1 : 0), matrix.row(9).size());
}

}  // namespace
}  // namespace hottel::exchange_rows_test::exchange_rows_test

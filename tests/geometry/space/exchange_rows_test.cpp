// View factors in parts, in any order.
#include "geometry/space/exchange/exchange_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <random>
#include <string>

#include "geometry/space/exchange/exchange.h"
#include "geometry/space/scene/division.h"
#include "io/scene/scene_json.h"
#include "kernel/support/interrupt.h"
#include "tests/same_matrix.h"

namespace hottel::exchange_rows_test {
namespace {

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

// Pairs of a scene, as they are handed on.
struct HandedPairs {
  std::vector<PairSum3> pairs;
  PairRanges known;
  int calls = 0;

  void take(std::span<const PairSum3> some, const PairRanges& ranges) {
    ++calls;
    for (std::uint32_t i = 0; i < ranges.elements(); ++i)
      for (const ColumnRange& range : ranges.ranges(i)) {
        for (std::uint32_t j = range.begin; j < range.end; ++j) EXPECT_FALSE(known.has(i, j)) << "handed on twice";
        known.add(i, range);
      }
    for (const PairSum3& pair : some) EXPECT_TRUE(ranges.has(pair.i, pair.j));
    EXPECT_TRUE(std::ranges::is_sorted(some, {}, [](const PairSum3& p) { return std::pair(p.i, p.j); }));
    pairs.insert(pairs.end(), some.begin(), some.end());
  }
};

TEST(ExchangeRows3, HandOnEachPairOnceAsItIsInTheEnd) {
  for (const Scene3& scene : scenes())
    for (const Granularity granularity : {Granularity::kElement, Granularity::kGroup}) {
      const PreparedScene3 prepared = prepare(scene);
      const ExchangeRequest request{.granularity = granularity};
      ExchangeRows3 alone(prepared, request);
      alone.add_all();
      alone.measure_alone();
      std::vector<PairSum3> expected(alone.pairs().begin(), alone.pairs().end());
      for (const double between : {0.0, 1000.0}) {
        HandedPairs handed;
        ExchangeRows3 rows(prepared, request);
        handed.known = PairRanges(rows.table().count());
        rows.hand_on([&](std::span<const PairSum3> pairs, const PairRanges& known) { handed.take(pairs, known); },
                     std::chrono::duration<double>(between));
        rows.add_all();
        EXPECT_TRUE(handed.known.has_all());
        EXPECT_EQ(handed.calls > 1, between == 0);
        std::ranges::sort(handed.pairs, {}, [](const PairSum3& p) { return std::pair(p.i, p.j); });
        EXPECT_EQ(handed.pairs, expected);
        expect_same(rows.matrix(), alone.missing() == 0 ? exact_exchange(prepared, request) : ExchangeMatrix());
      }
    }
}

// Whatever run takes what the ones before it left: the same matrix.
TEST(ExchangeRows3, GoOnWithWhatWasHandedOnBeforeTheyWereStopped) {
  std::mt19937_64 random(11);
  for (const Scene3& scene : scenes())
    for (const Granularity granularity : {Granularity::kElement, Granularity::kGroup}) {
      const PreparedScene3 prepared = prepare(scene);
      const ExchangeRequest request{.granularity = granularity};
      const ExchangeMatrix expected = exact_exchange(prepared, request);
      HandedPairs handed;
      int runs = 0, stopped = 0;
      for (bool is_done = false; !is_done; ++runs) {
        ASSERT_LT(runs, 10'000);
        ExchangeRows3 rows(prepared, request);
        if (runs == 0) handed.known = PairRanges(rows.table().count());
        rows.take(handed.pairs, handed.known);
        std::atomic<bool> stops{false};
        const StopScope scope(&stops);
        // The first run is stopped as soon as anything was handed on.
        const int last = handed.calls + 1 + (runs == 0 ? 0 : static_cast<int>(random() % 40));
        rows.hand_on(
            [&](std::span<const PairSum3> pairs, const PairRanges& known) {
              handed.take(pairs, known);
              stops = handed.calls >= last;
            },
            std::chrono::seconds(0));
        try {
          if (rows.missing() > 0) rows.add_all();
          expect_same(rows.matrix(), expected);
          is_done = true;
        } catch (const Interrupted&) {
          ++stopped;
        }
      }
      EXPECT_EQ(runs, stopped + 1);
      if (granularity == Granularity::kElement) {
        EXPECT_GT(stopped, 0);
      }
    }
}

}  // namespace
}  // namespace hottel::exchange_rows_test

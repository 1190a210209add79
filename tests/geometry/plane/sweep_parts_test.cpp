// A sweep that is ended and goes on: the same sums, bit for bit.
#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stdexcept>

#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/exchange/exchange_sums.h"
#include "tests/geometry/plane/exchange_scenes.h"

namespace hottel::sweep_parts::sweep_parts_test {
namespace {

using namespace testing_scenes;

class SweepPartsOfAScene : public testing::TestWithParam<std::string> {
 protected:
  const PreparedScene2 prepared_ = prepare(generated(GetParam(), 1200, 3));
  const ElementTable2 table_{prepared_.scene, prepared_.arrangement, prepared_.division, Granularity::kFace};

  std::vector<PairSum2> sums(SumCounts2& counts, SweepParts2* parts, const std::function<void(double)>& progress) {
    const PairSums2 sums = sum_visible_pairs(prepared_.arrangement, table_, progress,
                                             std::numeric_limits<std::uint64_t>::max(), counts, parts);
    std::vector<PairSum2> all;
    sums.for_each([&all](const PairSum2& sum) { all.push_back(sum); });
    return all;
  }
};

bool is_same_sum(const PairSum2& a, const PairSum2& b) {
  return a.key == b.key && a.inexact == b.inexact && a.is_obstructed == b.is_obstructed && a.value == b.value;
}

TEST_P(SweepPartsOfAScene, AddUpToTheSumsOfOneSweep) {
  SumCounts2 expected_counts;
  const std::vector<PairSum2> expected = sums(expected_counts, nullptr, {});
  const std::size_t places = prepared_.arrangement.triangulation().sweep_order().size();
  std::mt19937_64 random(5);
  for (int k = 0; k < 4; ++k) {
    std::vector<SweptPart2> kept;
    std::size_t runs = 0;
    for (bool is_done = false; !is_done; ++runs) {
      ASSERT_LT(runs, 1000U);
      SweepParts2 parts{.before = kept, .sink = {}, .between = std::chrono::seconds(k % 2 == 0 ? 0 : 1000)};
      parts.sink = [&kept](SweptPart2&& part) { kept.push_back(std::move(part)); };
      int rounds = static_cast<int>(random() % 3);
      SumCounts2 counts;
      try {
        const std::vector<PairSum2> all = sums(counts, &parts, [&rounds](double) {
          if (rounds-- == 0) throw std::runtime_error("ended");
        });
        is_done = true;
        EXPECT_TRUE(std::ranges::equal(all, expected, is_same_sum));
        EXPECT_EQ(counts.gaps, expected_counts.gaps);
        EXPECT_EQ(counts.updates, expected_counts.updates);
      } catch (const std::runtime_error&) {
      }
      // One that meets others is not taken; a part may come twice, from two runs.
      if (!kept.empty() && random() % 2 == 0) kept.push_back(kept[random() % kept.size()]);
    }
    EXPECT_GT(runs, 1U);
    std::size_t end = 0;
    for (const SweptPart2& part : kept) end = std::max(end, part.end);
    EXPECT_LE(end, places);
  }
}

TEST_P(SweepPartsOfAScene, ThatFillAHoleAreHandedOnApart) {
  SumCounts2 counts;
  std::vector<SweptPart2> all;
  SweepParts2 every{.before = {}, .sink = [&all](SweptPart2&& part) { all.push_back(std::move(part)); }, .between = {}};
  const std::vector<PairSum2> expected = sums(counts, &every, {});
  ASSERT_GT(all.size(), 2U);
  SweepParts2 parts{.before = {all[1]}, .sink = {}, .between = std::chrono::seconds(1000)};
  std::vector<SweptPart2> rest;
  parts.sink = [&rest](SweptPart2&& part) { rest.push_back(std::move(part)); };
  SumCounts2 again;
  EXPECT_TRUE(std::ranges::equal(sums(again, &parts, {}), expected, is_same_sum));
  EXPECT_EQ(again.gaps, counts.gaps);
  ASSERT_EQ(rest.size(), 2U);
  EXPECT_EQ(rest[0].begin, 0U);
  EXPECT_EQ(rest[0].end, all[1].begin);
  EXPECT_EQ(rest[1].begin, all[1].end);
  EXPECT_EQ(rest[1].end, all.back().end);
}

// The limit of memory is held against pairs, however many parts they were found in.
TEST_P(SweepPartsOfAScene, DoNotMoveTheLimitOfMemory) {
  SumCounts2 counts;
  const std::size_t pairs = sums(counts, nullptr, {}).size();
  const auto within = [&](std::uint64_t most, SweepParts2* parts) {
    SumCounts2 ignored;
    try {
      sum_visible_pairs(prepared_.arrangement, table_, {}, most, ignored, parts);
      return true;
    } catch (const RequestError&) {
      return false;
    }
  };
  std::vector<SweptPart2> kept;
  SweepParts2 parts{
      .before = {}, .sink = [&kept](SweptPart2&& part) { kept.push_back(std::move(part)); }, .between = {}};
  EXPECT_FALSE(within(pairs - 1, &parts));
  EXPECT_FALSE(kept.empty()) << "what was swept before the refusal";
  parts.before = kept;
  EXPECT_TRUE(within(pairs, &parts));
}

INSTANTIATE_TEST_SUITE_P(, SweepPartsOfAScene, testing::Values("clutter", "maze"),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace hottel::sweep_parts::sweep_parts_test

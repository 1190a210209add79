// The memory that the sums may take: refused before where it is foreseen, and stopped where the pairs become more than
// were foreseen.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "geometry/plane/exchange/exchange_sums.h"
#include "kernel/support/parallel.h"
#include "tests/geometry/plane/exchange_scenes.h"

namespace hottel::exchange_memory_test {
namespace {

using namespace testing_scenes;

class ExchangeMemory : public testing::Test {
 protected:
  const PreparedScene2 prepared_ = prepare(generated("comb", 300, 5));
  const ElementTable2 table_{prepared_.scene, prepared_.arrangement, prepared_.division, Granularity::kFace};
  const std::uint64_t foreseen_ = estimated_sight(prepared_.arrangement, table_).pairs;
  const std::uint64_t pairs_ = count();

  std::uint64_t count() const {
    SumCounts2 counts;
    return sum_visible_pairs(prepared_.arrangement, table_, {}, std::numeric_limits<std::uint64_t>::max(), counts)
        .size();
  }

  // What is thrown where memory for so many pairs is allowed; nothing where it is enough.
  std::string refusal(std::uint64_t pairs) const {
    try {
      exact_exchange(prepared_, {.memory = pairs * kBytesPerPair});
    } catch (const RequestError& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(ExchangeMemory, OfAllPairsIsEnough) { EXPECT_EQ(refusal(pairs_), ""); }

TEST_F(ExchangeMemory, BelowWhatIsForeseenIsRefusedBefore) {
  EXPECT_THAT(refusal(foreseen_ - 1), testing::StartsWith("about " + std::to_string(foreseen_) + " visible pairs"));
}

TEST_F(ExchangeMemory, StopsTheSweepWhereThePairsBecomeMoreThanForeseen) {
  ASSERT_LT(foreseen_, pairs_) << "of a comb";
  for (const std::uint64_t pairs : {foreseen_, pairs_ - 1}) {
    const std::string expected = "the scene has more than " + std::to_string(pairs) +
                                 " visible pairs, which is all that the memory allowed holds";
    for (const int threads : {1, 3}) {
      const ThreadLimit limit(threads);
      EXPECT_EQ(refusal(pairs), expected);
    }
  }
}

TEST_F(ExchangeMemory, ThatWasTooLittleLeavesThePreparedSceneAsItWas) {
  const Printed before = printed(exact_exchange(prepared_));
  EXPECT_NE(refusal(pairs_ - 1), "");
  EXPECT_TRUE(printed(exact_exchange(prepared_)) == before);
}

}  // namespace
}  // namespace hottel::exchange_memory_test

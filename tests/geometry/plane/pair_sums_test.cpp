// Sums by rows, and the places of their entries in a matrix.
#include "geometry/plane/exchange/pair_sums.h"

#include <gtest/gtest.h>

#include <limits>

#include "geometry/plane/exchange/exchange_sums.h"
#include "tests/geometry/plane/exchange_scenes.h"

namespace hottel::pair_sums_test {
namespace {

using namespace testing_scenes;

struct Case {
  std::string kind;
  Granularity granularity;
};

class PairSums : public testing::TestWithParam<Case> {
 protected:
  static PairSums2 sums_of(const PreparedScene2& prepared, const ElementTable2& table) {
    SumCounts2 counts;
    return sum_visible_pairs(prepared.arrangement, table, {}, std::numeric_limits<std::uint64_t>::max(), counts);
  }

  const PreparedScene2 prepared_ = prepare(in_groups_of_five(generated(GetParam().kind, 200, 3)));
  const ElementTable2 table_{prepared_.scene, prepared_.arrangement, prepared_.division, GetParam().granularity};
  const PairSums2 sums_ = sums_of(prepared_, table_);
};

TEST_P(PairSums, RowsAscendAndHoldEachPairUnderItsSmallerLabel) {
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < sums_.rows(); ++i) {
    EXPECT_EQ(sums_.before(i), count);
    std::uint64_t last = 0;
    for (const PairSum2& sum : sums_.row(i)) {
      EXPECT_EQ(sum.i(), i);
      EXPECT_GE(sum.j(), i);
      EXPECT_TRUE(count == 0 || sum.key > last);
      last = sum.key;
      ++count;
    }
  }
  EXPECT_EQ(sums_.before(sums_.rows()), count);
  EXPECT_EQ(sums_.size(), count);
  EXPECT_GT(count, 0u);
}

// Properties (1) and (2) of EntryPlaces2.
TEST_P(PairSums, EntriesTakeEveryPlaceOfARowOnceAscendingByColumn) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  const EntryPlaces2 places(sums_, table_);
  ASSERT_EQ(places.begin().size(), table_.count() + 1u);
  std::vector<std::uint32_t> column(places.begin().back(), kNone), row(column);
  const auto put = [&](std::size_t place, std::uint32_t from, std::uint32_t to) {
    ASSERT_LT(place, column.size());
    EXPECT_EQ(column[place], kNone);
    column[place] = to;
    row[place] = from;
  };
  std::size_t k = 0;
  for (std::uint32_t i = 0; i < sums_.rows(); ++i)
    for (const PairSum2& sum : sums_.row(i)) {
      if (table_.has_row(i)) put(places.forth(i, k), i, sum.j());
      if (sum.j() != i && table_.has_row(sum.j())) put(places.back(sum.j(), k), sum.j(), i);
      ++k;
    }
  for (std::uint32_t i = 0; i < table_.count(); ++i) {
    EXPECT_EQ(places.row_size(i), places.begin()[i + 1] - places.begin()[i]);
    EXPECT_TRUE(table_.has_row(i) || places.row_size(i) == 0);
    for (std::size_t place = places.begin()[i]; place < places.begin()[i + 1]; ++place) {
      EXPECT_EQ(row[place], i);
      EXPECT_TRUE(place == places.begin()[i] || column[place - 1] < column[place]);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, PairSums,
                         testing::Values(Case{"clutter", Granularity::kFace}, Case{"lattice", Granularity::kFace},
                                         Case{"plates", Granularity::kFace}, Case{"clutter", Granularity::kGroup},
                                         Case{"room", Granularity::kGroup}),
                         [](const auto& test) {
                           return test.param.kind +
                                  (test.param.granularity == Granularity::kGroup ? "Groups" : "Faces");
                         });

TEST(PairSum, CountsMoreLengthsThanWordsOf32Bits) {
  PairSum2 sum{.key = pair_key(3, 2)};
  PairSum2 term{.key = sum.key, .inexact = 3'000'000'000, .is_obstructed = 0, .value = 5};
  sum.add(term);
  term.is_obstructed = 1;
  sum.add(term);
  EXPECT_EQ(sum.i(), 2u);
  EXPECT_EQ(sum.j(), 3u);
  EXPECT_EQ(std::uint64_t{sum.inexact}, 6'000'000'000u);
  EXPECT_EQ(sum.is_obstructed, 1u);
  EXPECT_EQ(sum.sum(0.5).error, 3e9);
  EXPECT_TRUE(sum.value == 10);
}

}  // namespace
}  // namespace hottel::pair_sums_test

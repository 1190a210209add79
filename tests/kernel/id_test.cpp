#include "kernel/support/id.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <type_traits>
#include <unordered_set>
#include <vector>

namespace hottel::id_test {
namespace {

using AppleId = Id<struct AppleTag>;
using PearId = Id<struct PearTag>;

template <class A, class B>
concept AreComparable = requires(A a, B b) {
  a == b;
};

// What numbers do, and an id does not.
template <class A>
concept IsANumber = requires(A a) {
  a + 1;
}
|| requires(A a) { a % 2; }
|| std::is_convertible_v<A, std::size_t>;

TEST(Id, IsNoNumberAndNoIdOfAnotherKind) {
  static_assert(!std::is_convertible_v<int, AppleId> && !std::is_convertible_v<PearId, AppleId>);
  static_assert(!std::is_constructible_v<AppleId, PearId> && !std::is_constructible_v<AppleId, double>);
  static_assert(AreComparable<AppleId, AppleId> && !AreComparable<AppleId, PearId> && !AreComparable<AppleId, int>);
  static_assert(!IsANumber<AppleId> && IsANumber<int>);
}

TEST(Id, IsAsLargeAndAsPlainAsAnInteger) {
  static_assert(sizeof(AppleId) == sizeof(std::int32_t));
  static_assert(std::is_trivially_copyable_v<AppleId> && std::is_trivially_default_constructible_v<AppleId>);
}

TEST(Id, IsOrderedByNumberAfterNone) {
  EXPECT_LT(AppleId::none(), AppleId(-1));
  EXPECT_LT(AppleId(-1), AppleId(0));
  EXPECT_LT(AppleId(2), AppleId(10));
  EXPECT_TRUE(AppleId::none().is_none());
  EXPECT_FALSE(AppleId(0).is_none());
  EXPECT_FALSE(AppleId(-1).is_none());
  EXPECT_EQ(AppleId(7).index(), 7u);
}

TEST(Id, RangesHoldTheFirstOnes) {
  const IdRange<AppleId> three(3), nothing(0);
  EXPECT_THAT(std::vector<AppleId>(three.begin(), three.end()),
              testing::ElementsAre(AppleId(0), AppleId(1), AppleId(2)));
  EXPECT_EQ(nothing.begin(), nothing.end());
  EXPECT_EQ(std::unordered_set<AppleId>(three.begin(), three.end()).size(), 3u);
}

}  // namespace
}  // namespace hottel::id_test

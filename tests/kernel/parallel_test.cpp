#include "kernel/support/parallel.h"

#include <gtest/gtest.h>

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

#include <algorithm>
#include <atomic>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace hottel::parallel_test {
namespace {

constexpr std::size_t kMany = 100'000;

TEST(Parallel, VisitsEveryIndexOnce) {
  for (const int threads : {1, 2, 3, 7}) {
    const ThreadLimit limit(threads);
    for (const std::size_t grain : {std::size_t{1}, std::size_t{64}, kMany, 2 * kMany}) {
      std::vector<int> visits(kMany, 0);
      parallel_for(
          kMany, [&visits](std::size_t k) { ++visits[k]; }, grain);
      EXPECT_EQ(std::accumulate(visits.begin(), visits.end(), 0), static_cast<int>(kMany));
      EXPECT_EQ(*std::min_element(visits.begin(), visits.end()), 1);
    }
  }
  parallel_for(0, [](std::size_t) { FAIL(); });
}

// What rounding upward, or flushing subnormal numbers to zero, would change.
#ifdef __SSE2__
constexpr unsigned kFlush = 0x8040;  // results and arguments that are subnormal become zero
unsigned control() { return _mm_getcsr(); }
void set_control(unsigned value) { _mm_setcsr(value); }
#else
constexpr unsigned kFlush = 0;
unsigned control() { return 0; }
void set_control(unsigned) {}
#endif

struct Arithmetic {
  bool rounds_to_nearest, keeps_subnormals;
};
Arithmetic arithmetic_here() {
  volatile double one = 1, tiny = 0x1p-60, smallest = std::numeric_limits<double>::min();
  return {one + tiny == 1 && std::fegetround() == FE_TONEAREST, smallest / 2 > 0};
}

TEST(Parallel, TellsHowManyThreadsMayWork) {
  const int all = threads_allowed();
  EXPECT_GE(all, 1);
  {
    const ThreadLimit one(1), many(1000);
    EXPECT_EQ(threads_allowed(), 1);
  }
  EXPECT_EQ(threads_allowed(), all);
}

TEST(Parallel, RoundsToNearestAndKeepsSubnormalsOnEveryThread) {
  const unsigned saved = control();
  const int saved_round = std::fegetround();
  std::fesetround(FE_UPWARD);
  set_control(control() | kFlush);
  ASSERT_FALSE(arithmetic_here().rounds_to_nearest);
  ASSERT_EQ(arithmetic_here().keeps_subnormals, kFlush == 0);
  std::atomic<int> wrong{0};
  const ThreadLimit limit(7);
  parallel_for(kMany, [&wrong](std::size_t) {
    const Arithmetic arithmetic = arithmetic_here();
    if (!arithmetic.rounds_to_nearest || !arithmetic.keeps_subnormals) ++wrong;
  });
  const bool is_restored = std::fegetround() == FE_UPWARD && (control() & kFlush) == kFlush;
  std::fesetround(saved_round);
  set_control(saved);
  EXPECT_EQ(wrong, 0);
  EXPECT_TRUE(is_restored);
}

TEST(Parallel, ThrowsTheFirstExceptionAgainAndStops) {
  std::atomic<std::size_t> begun{0};
  const auto work = [&begun](std::size_t) {
    ++begun;
    throw std::runtime_error("no");
  };
  EXPECT_THROW(parallel_for(kMany, work), std::runtime_error);
  EXPECT_LT(begun, kMany);
}

TEST(Parallel, MayBeCalledFromWithin) {
  std::atomic<std::size_t> visits{0};
  parallel_for(100, [&visits](std::size_t) { parallel_for(100, [&visits](std::size_t) { ++visits; }); });
  EXPECT_EQ(visits, 10'000u);
}

}  // namespace
}  // namespace hottel::parallel_test

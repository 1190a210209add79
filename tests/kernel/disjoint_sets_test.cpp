// Sets that many threads join: those of one thread.
#include "kernel/support/disjoint_sets.h"

#include <gtest/gtest.h>

#include <random>

#include "kernel/support/parallel.h"

namespace hottel::disjoint_sets_test {
namespace {

// Property (1).
TEST(SharedDisjointSets, HaveTheirSmallestNumberAsRootWhoeverJoinsThem) {
  const ThreadLimit limit(4);
  std::mt19937_64 random(5);
  for (std::uint32_t n : {1U, 2U, 50U, 3000U, 100'000U})
    for (const double joins_a_number : {0.3, 0.6, 2.0}) {
      std::vector<std::pair<std::uint32_t, std::uint32_t>> joins(static_cast<std::size_t>(joins_a_number * n));
      for (auto& [a, b] : joins) {
        a = static_cast<std::uint32_t>(random() % n);
        b = static_cast<std::uint32_t>(random() % 4 == 0 ? random() % n : (a + 1) % n);
      }
      SharedDisjointSets shared(n);
      parallel_for(joins.size(), [&](std::size_t k) { shared.join(joins[k].first, joins[k].second); });
      DisjointSets alone(n);
      for (const auto& [a, b] : joins) alone.join_to_smaller(a, b);
      for (std::uint32_t k = 0; k < n; ++k) ASSERT_EQ(shared.root(k), alone.root(k)) << k << " of " << n;
    }
}

}  // namespace
}  // namespace hottel::disjoint_sets_test

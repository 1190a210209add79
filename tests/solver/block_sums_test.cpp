// Sums on all threads: the same for any number of them, and of few terms those of a loop.
#include "solver/radiosity/block_sums.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "kernel/support/parallel.h"

namespace hottel::block_sums_test {
namespace {

std::vector<double> terms(std::size_t n) {
  std::mt19937_64 random(n + 1);
  std::vector<double> result(n);
  for (double& term : result)
    term = std::ldexp(std::uniform_real_distribution<>(-1, 1)(random), static_cast<int>(random() % 40));
  return result;
}

template <class Work>
auto on_threads(int threads, const Work& work) {
  const ThreadLimit limit(threads);
  return work();
}

TEST(BlockSums, OfFewTermsAreThoseOfALoop) {
  for (const std::size_t n : {std::size_t{0}, std::size_t{1}, std::size_t{1000}, kTermsInBlock}) {
    const std::vector<double> of = terms(n);
    std::vector<std::uint32_t> part(n);
    double sum = 0, largest = 0;
    std::vector<double> sums(3, 0);
    for (std::size_t i = 0; i < n; ++i) {
      part[i] = static_cast<std::uint32_t>(i * i % 3);
      sum += of[i];
      largest = std::max(largest, of[i]);
      sums[part[i]] += of[i];
    }
    const auto term = [&](std::size_t i) { return of[i]; };
    EXPECT_EQ(block_sum(n, term), sum);
    EXPECT_EQ(block_largest(n, term), largest);
    EXPECT_EQ(block_sums(part, 3, term), sums);
  }
}

TEST(BlockSums, DoNotDependOnThreads) {
  for (const std::size_t n : {kTermsInBlock + 1, 10 * kTermsInBlock, std::size_t{300'000}})
    for (const std::size_t parts : {1, 7, 1000}) {
      const std::vector<double> of = terms(n);
      std::vector<std::uint32_t> part(n);
      for (std::size_t i = 0; i < n; ++i) part[i] = static_cast<std::uint32_t>(i * 7919 % parts);
      const auto term = [&](std::size_t i) { return of[i]; };
      for (const int threads : {2, 5}) {
        const auto same = [&](const auto& work) { EXPECT_EQ(on_threads(1, work), on_threads(threads, work)); };
        same([&] { return block_sum(n, term); });
        same([&] { return block_largest(n, term); });
        same([&] { return block_sums(part, parts, term); });
      }
      long double sum = 0, size = 0;
      for (const double each : of) {
        sum += each;
        size += std::abs(each);
      }
      EXPECT_NEAR(block_sum(n, term), static_cast<double>(sum), 1e-12 * static_cast<double>(size));
      double of_parts = 0;
      for (const double each : block_sums(part, parts, term)) of_parts += each;
      EXPECT_NEAR(of_parts, static_cast<double>(sum), 1e-12 * static_cast<double>(size));
    }
}

}  // namespace
}  // namespace hottel::block_sums_test

#include "geometry/pair_table.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <span>
#include <vector>

namespace hottel::pair_table_test {
namespace {

// A sum that tells in which order its terms were added.
struct Trace {
  std::uint64_t key = 0;
  std::vector<int> numbers;

  void add(const Trace& term) { numbers.insert(numbers.end(), term.numbers.begin(), term.numbers.end()); }
};

std::vector<Trace> random_terms(std::size_t count, std::uint64_t keys, std::mt19937_64& random) {
  std::vector<Trace> terms;
  for (std::size_t n = 0; n < count; ++n) terms.push_back({random() % keys, {static_cast<int>(n)}});
  return terms;
}

void expect_the_terms(const std::vector<Trace>& sums, const std::vector<Trace>& terms) {
  std::map<std::uint64_t, std::vector<int>> expected;
  for (const Trace& term : terms) expected[term.key].push_back(term.numbers.front());
  ASSERT_EQ(sums.size(), expected.size());
  auto sum = sums.begin();
  for (const auto& [key, numbers] : expected) {  // ascending: (1)
    EXPECT_EQ(sum->key, key);
    EXPECT_EQ(sum->numbers, numbers);  // (2)
    ++sum;
  }
}

TEST(PairTable, HasEachKeyOnceWithItsTermsInTheOrderOfTheCalls) {
  std::mt19937_64 random(1);
  PairTable<Trace> table;
  for (const std::size_t count : {0u, 1u, 7u, 8u, 9u, 100u, 5000u}) {  // (3): the same table again
    const std::vector<Trace> terms = random_terms(count, 1 + count / 3, random);
    for (const Trace& term : terms) table.add(term);
    expect_the_terms(table.take(), terms);
    EXPECT_EQ(table.size(), 0u);
  }
}

TEST(PairTable, TakesManyTermsAtOnceAsOneByOne) {
  std::mt19937_64 random(2);
  PairTable<Trace> table;
  for (const std::size_t count : {0u, 1u, 7u, 8u, 9u, 100u, 5000u}) {
    const std::vector<Trace> terms = random_terms(count, 1 + count / 3, random);
    const auto half = std::span(terms).first(count / 2);
    table.add(half);
    table.add(std::span(terms).subspan(count / 2));
    expect_the_terms(table.take(), terms);
  }
}

TEST(PairTable, TellsKeysApartThatDifferInAnyBit) {
  PairTable<Trace> table;
  std::vector<Trace> terms;
  for (int bit = 0; bit < 63; ++bit) terms.push_back({std::uint64_t{1} << bit, {bit}});
  for (const Trace& term : terms) table.add(term);
  table.add(std::span<const Trace>(terms));
  EXPECT_EQ(table.size(), 63u);
  for (const Trace& sum : table.take()) EXPECT_EQ(sum.numbers.size(), 2u);
}

}  // namespace
}  // namespace hottel::pair_table_test

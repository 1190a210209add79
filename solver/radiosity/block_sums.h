// Sums and maxima of many numbers on all threads, rounded as if one thread had formed them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "kernel/support/parallel.h"

namespace hottel {

// Terms are added in blocks, one after the other, and then the sums of the blocks. What is a block depends on the
// number of terms alone, so sums do not depend on the number of threads; so few terms as this are one block.
inline constexpr std::size_t kTermsInBlock = 16384;

// Calls f(block, begin, end) for all blocks of n terms.
template <class F>
void of_blocks(std::size_t n, const F& f) {
  parallel_for((n + kTermsInBlock - 1) / kTermsInBlock, [&](std::size_t block) {
    const std::size_t begin = block * kTermsInBlock;
    f(block, begin, std::min(n, begin + kTermsInBlock));
  });
}

// Returns the sum of term(i) for i in [0, n).
template <class Term>
double block_sum(std::size_t n, const Term& term) {
  std::vector<double> sums(n / kTermsInBlock + 1, 0);
  of_blocks(n, [&](std::size_t block, std::size_t begin, std::size_t end) {
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i) sum += term(i);
    sums[block] = sum;
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

// Returns the largest term(i) for i in [0, n), or 0 where none is above.
template <class Term>
double block_largest(std::size_t n, const Term& term) {
  std::vector<double> all(n / kTermsInBlock + 1, 0);
  of_blocks(n, [&](std::size_t block, std::size_t begin, std::size_t end) {
    double largest = 0;
    for (std::size_t i = begin; i < end; ++i) largest = std::max(largest, term(i));
    all[block] = largest;
  });
  return *std::ranges::max_element(all);
}

// Returns the sums of term(i) over all i of each part; part[i] < parts. Where there are many parts they are formed by
// one thread, without blocks.
template <class Term>
std::vector<double> block_sums(const std::vector<std::uint32_t>& part, std::size_t parts, const Term& term) {
  constexpr std::size_t kFew = 16;
  const std::size_t n = part.size();
  const auto add = [&](double* sums, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) sums[part[i]] += term(i);
  };
  std::vector<double> result(parts, 0);
  if (parts > kFew || n <= kTermsInBlock) {
    add(result.data(), 0, n);
    return result;
  }
  std::vector<double> sums((n / kTermsInBlock + 1) * parts, 0);
  of_blocks(n, [&](std::size_t block, std::size_t begin, std::size_t end) { add(&sums[block * parts], begin, end); });
  for (std::size_t k = 0; k < sums.size(); ++k) result[k % parts] += sums[k];
  return result;
}

}  // namespace hottel

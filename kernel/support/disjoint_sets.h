// Numbers that are joined to sets.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace hottel {

// The numbers 0 .. n - 1, each in a set of its own until sets are joined. A set is known by one of its numbers, its
// root.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n = 0) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0u); }

  std::uint32_t root(std::uint32_t k) {
    while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
    return k;
  }
  // Joins the set of b to that of a, whose root stays.
  void join(std::uint32_t a, std::uint32_t b) { parent_[root(b)] = root(a); }
  // The same, but the smaller root stays.
  void join_to_smaller(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    parent_[a < b ? b : a] = a < b ? a : b;
  }
  // Makes numbers sets of their own again. REQUIRES all numbers of their sets.
  template <class Numbers>
  void separate(const Numbers& numbers) {
    for (const std::uint32_t k : numbers) parent_[k] = k;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace hottel

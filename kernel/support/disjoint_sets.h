// Numbers that are joined to sets.
#pragma once

#include <atomic>
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

// The same, where any number of threads may ask and join at once.
//
//   (1) once all joins are over the root of a set is its smallest number, whoever joined what, and when
class SharedDisjointSets {
 public:
  explicit SharedDisjointSets(std::size_t n) : parent_(n) {
    for (std::size_t k = 0; k < n; ++k) parent_[k].store(static_cast<std::uint32_t>(k), std::memory_order_relaxed);
  }

  std::uint32_t root(std::uint32_t k) {
    for (std::uint32_t above = parent(k); above != k; above = parent(k)) {
      // A parent is smaller, and stays above: whoever is the last to shorten the way leaves one that leads to the root.
      const std::uint32_t next = parent(above);
      parent_[k].store(next, std::memory_order_relaxed);
      k = next;
    }
    return k;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    for (;;) {
      a = root(a);
      b = root(b);
      if (a == b) return;
      if (a > b) std::swap(a, b);
      std::uint32_t still = b;  // a root, unless another thread was first
      if (parent_[b].compare_exchange_strong(still, a, std::memory_order_relaxed)) return;
    }
  }

 private:
  std::uint32_t parent(std::uint32_t k) const { return parent_[k].load(std::memory_order_relaxed); }

  std::vector<std::atomic<std::uint32_t>> parent_;
};

}  // namespace hottel

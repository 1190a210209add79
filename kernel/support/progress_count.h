// How far work on many threads has come, for whoever asked to be told.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>

namespace hottel {

// Counts what is done of a total and tells the fraction about a thousand times.
//
//   (1) add() may be called from any thread, and calls `progress` on that thread; what that throws passes through
//   (2) the fraction told is above 0 and at most 1; without `progress` nothing is counted
// REQUIRES that `progress` outlives this. COST: one atomic addition.
class ProgressCount {
 public:
  ProgressCount(const std::function<void(double)>& progress, std::size_t total)
      : progress_(progress), total_(total), step_(total / 1000 + 1) {}

  // So much more is done.
  void add(std::size_t amount = 1) {
    if (!progress_) return;
    const std::size_t done = done_.fetch_add(amount, std::memory_order_relaxed) + amount;
    if (done / step_ != (done - amount) / step_ || done == total_)
      progress_(static_cast<double>(done) / static_cast<double>(total_));
  }

 private:
  const std::function<void(double)>& progress_;
  const std::size_t total_, step_;
  std::atomic<std::size_t> done_{0};
};

}  // namespace hottel

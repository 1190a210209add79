// Pairs of elements that are handed on while others are still being measured.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/pair_ranges.h"
#include "geometry/space/exchange/pair_tasks.h"

namespace hottel {

// Hands pairs on, every few seconds those whose patches have all been measured since.
//
//   (1) a pair is handed on once, with its sum, which is the final one; one that is open is not before it is settled,
//   nor one that could not be
//       measured
//   (2) the pairs of `known` are those that this turn asks for, and those that nobody asks for as neither element has
//       a row; those of them that are not in the list exchange nothing
//   (3) what was handed on is moved out of the lists of tasks
// COST: a clock and an atomic bit a task; each time a bit for each task of rows that are not done.
class PairHandover3 {
 public:
  // REQUIRES that all outlive this; labels are those of the table's holders.
  PairHandover3(const ElementTable3& table, const std::vector<std::uint32_t>& labels, const PairTasks3& tasks,
                const PairSumRequest3& request, FoundOfTasks3& found);

  // Task t is done: what it found is complete. From any thread; hands on where it is time to. Throws what the sink
  // throws.
  void has_done(std::size_t task);
  // Hands on all that is complete. REQUIRES that no other thread does.
  void hand_over();
  // Hands on, and takes out of the list, pairs that were open, but for those that have failed. REQUIRES that no task
  // runs; both by (i, j).
  void hand_over_settled(std::vector<PairSum3>& pairs, const std::vector<FailedPair3>& failures);
  // All that was handed on, by (i, j), unless the sink has it alone. REQUIRES that no task runs; may be called once.
  std::vector<PairSum3> take();

 private:
  using Clock = std::chrono::steady_clock;

  std::vector<ColumnRange> complete_columns(std::uint32_t label) const;
  std::vector<ColumnRange> columns_of(std::size_t patch, std::uint32_t label) const;
  bool is_ours(std::uint32_t i, std::uint32_t j) const;
  void add_row(std::uint32_t label, const std::vector<ColumnRange>& columns, PairRanges& known,
               std::vector<PairSum3>& pairs);
  bool is_done(std::size_t task) const {
    return (done_[task / kBits].load(std::memory_order_acquire) >> (task % kBits) & 1) != 0;
  }

  const ElementTable3& table_;
  const std::vector<std::uint32_t>& labels_;
  const PairTasks3& tasks_;
  const PairSumRequest3& request_;
  FoundOfTasks3& found_;
  static constexpr std::size_t kBits = 64;
  std::unique_ptr<std::atomic<std::uint64_t>[]> done_;  // a bit a task
  std::atomic<Clock::rep> next_;
  std::atomic_flag is_busy_;
  PairRanges seen_;  // columns that were complete before
  std::vector<PairSum3> handed_;
};

}  // namespace hottel

#include "geometry/plane/exchange/term_sums.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <mutex>

#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"

namespace hottel {
namespace {

// A round of vertices is cut into so many runs, whoever sweeps them.
constexpr std::size_t kRuns = 32;

// The buffers of a round. Where order matters each run has its own; else it takes any that is free, so that there are
// no more than threads.
template <class Term>
class Outboxes {
 public:
  explicit Outboxes(const TermBuffer2<Term>& empty) : empty_(empty) {
    if (Term::kOrderMatters) all_.assign(kRuns, empty);
  }

  TermBuffer2<Term>& take(std::size_t run) {
    if (Term::kOrderMatters) return all_[run];
    const std::lock_guard lock(mutex_);
    if (free_.empty()) return all_.emplace_back(empty_);
    TermBuffer2<Term>& buffer = *free_.back();
    free_.pop_back();
    return buffer;
  }
  void give_back(TermBuffer2<Term>& buffer) {
    if (Term::kOrderMatters) return;
    const std::lock_guard lock(mutex_);
    free_.push_back(&buffer);
  }

  std::deque<TermBuffer2<Term>>& all() { return all_; }

 private:
  const TermBuffer2<Term> empty_;
  std::deque<TermBuffer2<Term>> all_;
  std::vector<TermBuffer2<Term>*> free_;
  std::mutex mutex_;
};

}  // namespace

template <class Term>
std::vector<std::vector<Term>> sum_terms(std::span<const VertexId> order, std::size_t labels,
                                         const TermSweep<Term>& sweep, const std::function<void(double)>& progress,
                                         std::uint64_t most_pairs, SumCounts2& counts) {
  // So many that the table of one stays in the cache with millions of pairs, so few that a small scene has few tables.
  constexpr std::size_t kPartitions = 256;
  int partition_shift = 5;  // 32 labels and more share a table
  while ((labels >> partition_shift) > kPartitions) ++partition_shift;
  const std::size_t partitions = ((labels - 1) >> partition_shift) + 1;
  std::vector<PairTable<Term>> tables(partitions);

  // Rounds: sweep some vertices, then empty the buffers into the tables. A round is as large as keeps the terms in
  // flight near kTermsInFlight, judged by the round before.
  constexpr std::size_t kTermsInFlight = 1 << 19;
  Outboxes<Term> buffers(TermBuffer2<Term>(partitions, partition_shift));
  std::size_t round = 64;
  for (std::size_t begin = 0; begin < order.size();) {
    const std::size_t size = std::min(round, order.size() - begin);
    parallel_for(kRuns, [&](std::size_t run) {
      TermBuffer2<Term>& out = buffers.take(run);
      for (std::size_t v = begin + run * size / kRuns; v != begin + (run + 1) * size / kRuns; ++v) sweep(order[v], out);
      out.flush();
      buffers.give_back(out);
    });
    std::size_t in_flight = 0;
    for (const TermBuffer2<Term>& out : buffers.all()) in_flight += out.size();
    parallel_for(partitions, [&](std::size_t partition) {
      for (TermBuffer2<Term>& out : buffers.all()) {
        tables[partition].add(out.partition(partition));
        out.partition(partition).clear();
      }
    });
    std::uint64_t pairs = 0;
    for (const auto& table : tables) pairs += table.size();
    if (pairs > most_pairs)
      throw RequestError(fmt::format(
          "the scene has more than {} visible pairs, which is all that the memory allowed holds", most_pairs));
    begin += size;
    round = std::clamp<std::size_t>(round * kTermsInFlight / (in_flight + 1), std::max<std::size_t>(16, round / 4),
                                    4 * round);
    if (progress) progress(static_cast<double>(begin) / static_cast<double>(order.size()));
  }
  for (const TermBuffer2<Term>& out : buffers.all()) {
    counts.gaps += out.gaps;
    counts.updates += out.updates;
  }

  std::vector<std::vector<Term>> sums(partitions);
  parallel_for(partitions, [&](std::size_t k) { sums[k] = tables[k].take(); });
  return sums;
}

template std::vector<std::vector<PairSum2>> sum_terms(std::span<const VertexId>, std::size_t,
                                                      const TermSweep<PairSum2>&, const std::function<void(double)>&,
                                                      std::uint64_t, SumCounts2&);
template std::vector<std::vector<PlainTerm2>> sum_terms(std::span<const VertexId>, std::size_t,
                                                        const TermSweep<PlainTerm2>&,
                                                        const std::function<void(double)>&, std::uint64_t, SumCounts2&);

}  // namespace hottel

#include "geometry/plane/exchange/term_sums.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <exception>
#include <mutex>
#include <utility>

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

// Adds parts that were swept elsewhere or before. shift: of the partitions.
template <class Term>
void add_parts(std::span<const SweptPart<Term>> parts, int shift, std::vector<PairTable<Term>>& tables,
               SumCounts2& counts) {
  for (const SweptPart<Term>& part : parts) {
    counts.gaps += part.counts.gaps;
    counts.updates += part.counts.updates;
  }
  parallel_for(tables.size(), [&](std::size_t k) {
    const auto partition = [shift](const Term& term) { return term.key >> (32 + shift); };
    for (const SweptPart<Term>& part : parts)
      tables[k].add(std::span(std::ranges::lower_bound(part.sums, k, {}, partition),
                              std::ranges::upper_bound(part.sums, k, {}, partition)));
  });
}

// The part of a sweep that is in hand, summed beside the whole, and those from before.
template <class Term>
class PartsInHand {
 public:
  PartsInHand(SweepParts<Term>* parts, std::size_t places, std::size_t partitions) : parts_(parts), places_(places) {
    if (parts == nullptr) return;
    HOTTEL_REQUIRE(!Term::kOrderMatters);
    tables_.resize(partitions);
    std::vector<SweptPart<Term>>& before = parts->before;
    std::ranges::sort(before, {}, &SweptPart<Term>::begin);
    std::size_t end = 0;
    std::erase_if(before, [&](const SweptPart<Term>& part) {
      if (part.begin < end || part.begin >= part.end || part.end > places) return true;
      end = part.end;
      return false;
    });
  }

  // The next place that is to be swept, and where the places to be swept from there end.
  std::size_t next(std::size_t place) const {
    if (parts_ != nullptr)
      for (const SweptPart<Term>& part : parts_->before)
        if (part.begin <= place && place < part.end) place = part.end;
    return place;
  }
  std::size_t end(std::size_t place) const {
    if (parts_ != nullptr)
      for (const SweptPart<Term>& part : parts_->before)
        if (part.begin > place) return part.begin;
    return places_;
  }

  // Terms of places that are not in the part yet; told all together by have_swept().
  void add(std::size_t partition, std::span<const Term> terms) {
    if (parts_ != nullptr) tables_[partition].add(terms);
  }
  // Between these the part has terms of places that it is not said to have.
  void begin_adding(std::size_t place) {
    is_whole_ = false;
    if (begin_ == end_) begin_ = end_ = place;
  }
  void have_swept(std::size_t end, const SumCounts2& all) {
    is_whole_ = true;
    end_ = end;
    now_ = all;
    if (parts_ != nullptr && (next(end) != end || std::chrono::steady_clock::now() - since_ >= parts_->between))
      hand_on();
  }

  void hand_on() {
    if (parts_ == nullptr || !is_whole_ || begin_ == end_) return;
    SweptPart<Term> part{begin_, end_, {now_.gaps - told_.gaps, now_.updates - told_.updates}, {}};
    std::vector<std::vector<Term>> sums(tables_.size());
    parallel_for(tables_.size(), [&](std::size_t k) { sums[k] = tables_[k].take(); });
    for (const std::vector<Term>& some : sums) part.sums.insert(part.sums.end(), some.begin(), some.end());
    begin_ = end_;
    told_ = now_;
    has_handed_ = true;
    parts_->sink(std::move(part));
    since_ = std::chrono::steady_clock::now();
  }
  // A sweep that took less than the time between two parts is not worth one.
  void finish() {
    if (has_handed_) hand_on();
  }
  // What comes after is told whatever comes of this.
  void hand_on_before_failure() {
    try {
      hand_on();
    } catch (const std::exception&) {
    }
  }

 private:
  SweepParts<Term>* parts_;  // null: none are asked for
  std::size_t places_;
  std::vector<PairTable<Term>> tables_;
  std::size_t begin_ = 0, end_ = 0;
  SumCounts2 now_, told_;
  bool is_whole_ = true, has_handed_ = false;
  std::chrono::steady_clock::time_point since_ = std::chrono::steady_clock::now();
};

}  // namespace

template <class Term>
std::vector<std::vector<Term>> sum_terms(std::span<const VertexId> order, std::size_t labels,
                                         const TermSweep<Term>& sweep, const std::function<void(double)>& progress,
                                         std::uint64_t most_pairs, SumCounts2& counts, SweepParts<Term>* parts,
                                         SharedWork<SweptPart<Term>>* work) {
  HOTTEL_REQUIRE(work == nullptr || (!Term::kOrderMatters && parts == nullptr));
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
  PartsInHand<Term> in_hand(parts, order.size(), partitions);
  if (parts != nullptr) add_parts<Term>(parts->before, partition_shift, tables, counts);
  const auto counted = [&buffers] {
    SumCounts2 all;
    for (const TermBuffer2<Term>& out : buffers.all()) {
      all.gaps += out.gaps;
      all.updates += out.updates;
    }
    return all;
  };
  const auto require_room = [&] {
    std::uint64_t pairs = 0;
    for (const auto& table : tables) pairs += table.size();
    if (pairs > most_pairs)
      throw RequestError(fmt::format(
          "the scene has more than {} visible pairs, which is all that the memory allowed holds", most_pairs));
  };
  const auto sweep_round = [&](std::size_t begin, std::size_t size) {
    parallel_for(kRuns, [&](std::size_t run) {
      TermBuffer2<Term>& out = buffers.take(run);
      for (std::size_t v = begin + run * size / kRuns; v != begin + (run + 1) * size / kRuns; ++v) sweep(order[v], out);
      out.flush();
      buffers.give_back(out);
    });
    std::size_t in_flight = 0;
    for (const TermBuffer2<Term>& out : buffers.all()) in_flight += out.size();
    in_hand.begin_adding(begin);
    parallel_for(partitions, [&](std::size_t partition) {
      for (TermBuffer2<Term>& out : buffers.all()) {
        tables[partition].add(out.partition(partition));
        in_hand.add(partition, out.partition(partition));
        out.partition(partition).clear();
      }
    });
    in_hand.have_swept(begin + size, counted());
    require_room();
    return in_flight;
  };
  std::size_t swept = 0, round = 64;
  const auto have = [&](std::size_t places) {
    swept += places;
    if (progress) progress(static_cast<double>(swept) / static_cast<double>(order.size()));
  };
  const auto sweep_places = [&](const WorkRange& places) {
    have(in_hand.next(places.begin) - places.begin);
    for (std::size_t begin = in_hand.next(places.begin); begin < places.end;) {
      const std::size_t size = std::min({round, in_hand.end(begin) - begin, places.end - begin});
      const std::size_t in_flight = sweep_round(begin, size);
      const std::size_t next = in_hand.next(begin + size);
      round = std::clamp<std::size_t>(round * kTermsInFlight / (in_flight + 1), std::max<std::size_t>(16, round / 4),
                                      4 * round);
      have(next - begin);
      begin = next;
    }
  };
  const auto sweep_with_others = [&] {
    WorkCount done;
    for (auto turn = work->next(); !turn.is_over(); turn = work->next()) {
      if (turn.there) {
        add_parts<Term>(std::span(&*turn.there, 1), partition_shift, tables, counts);
        require_room();
        have(turn.there->end - turn.there->begin);
        done.add({turn.there->begin, turn.there->end});
      } else {
        sweep_places(turn.here);
        done.add(turn.here);
      }
    }
    HOTTEL_REQUIRE(done.has_each_once(order.size()));
  };
  try {
    if (work == nullptr)
      sweep_places({0, order.size()});
    else
      sweep_with_others();
  } catch (...) {
    in_hand.hand_on_before_failure();
    throw;
  }
  in_hand.finish();
  counts.gaps += counted().gaps;
  counts.updates += counted().updates;

  std::vector<std::vector<Term>> sums(partitions);
  parallel_for(partitions, [&](std::size_t k) { sums[k] = tables[k].take(); });
  return sums;
}

template std::vector<std::vector<PairSum2>> sum_terms(std::span<const VertexId>, std::size_t,
                                                      const TermSweep<PairSum2>&, const std::function<void(double)>&,
                                                      std::uint64_t, SumCounts2&, SweepParts<PairSum2>*,
                                                      SharedWork<SweptPart<PairSum2>>*);
template std::vector<std::vector<PlainTerm2>> sum_terms(std::span<const VertexId>, std::size_t,
                                                        const TermSweep<PlainTerm2>&,
                                                        const std::function<void(double)>&, std::uint64_t, SumCounts2&,
                                                        SweepParts<PlainTerm2>*, SharedWork<SweptPart<PlainTerm2>>*);

}  // namespace hottel

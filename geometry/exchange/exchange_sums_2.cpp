#include "geometry/exchange/exchange_sums_2.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <random>

#include "geometry/exchange/gap_terms_2.h"
#include "kernel/failure.h"

namespace hottel {
namespace {

struct Term {
  std::uint64_t key;  // i << 32 | j, i <= j
  std::uint32_t is_inexact;
  std::uint32_t is_obstructed;
  Int128 value;
};

constexpr std::uint64_t key_of(std::uint32_t i, std::uint32_t j) {
  return i <= j ? (static_cast<std::uint64_t>(i) << 32) | j : (static_cast<std::uint64_t>(j) << 32) | i;
}

// Sums by pair: open addressing with linear probing.
class PairTable {
 public:
  void add(const Term& term) {
    if (4 * (count_ + 1) > 3 * slots_.size()) grow();
    Term& slot = find(term.key);
    if (slot.key == kEmpty) {
      slot = term;
      ++count_;
      return;
    }
    // Only the final sum is bounded: on the way it may wrap around.
    slot.value = static_cast<Int128>(static_cast<UInt128>(slot.value) + static_cast<UInt128>(term.value));
    slot.is_inexact += term.is_inexact;
    slot.is_obstructed |= term.is_obstructed;
  }

  std::size_t size() const { return count_; }

  // Moves the sums out, sorted.
  std::vector<PairSum> take() {
    std::erase_if(slots_, [](const Term& slot) { return slot.key == kEmpty; });
    std::sort(slots_.begin(), slots_.end(), [](const Term& a, const Term& b) { return a.key < b.key; });
    std::vector<PairSum> result;
    result.reserve(slots_.size());
    for (const Term& slot : slots_)
      result.push_back({static_cast<std::uint32_t>(slot.key >> 32), static_cast<std::uint32_t>(slot.key),
                        slot.is_inexact, slot.is_obstructed != 0, slot.value});
    std::vector<Term>().swap(slots_);
    count_ = 0;
    return result;
  }

 private:
  static constexpr std::uint64_t kEmpty = ~std::uint64_t{0};

  Term& find(std::uint64_t key) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t place = (key * 0x9e3779b97f4a7c15ull) >> shift_;
    while (slots_[place].key != kEmpty && slots_[place].key != key) place = (place + 1) & mask;
    return slots_[place];
  }

  void grow() {
    std::vector<Term> old(std::max<std::size_t>(64, 2 * slots_.size()), Term{kEmpty, 0, 0, 0});
    old.swap(slots_);
    shift_ = 64 - std::countr_zero(slots_.size());
    for (const Term& slot : old)
      if (slot.key != kEmpty) find(slot.key) = slot;
  }

  std::vector<Term> slots_;
  std::size_t count_ = 0;
  int shift_ = 0;
};

// Terms on their way from the sweeps to the tables, by partition of the smaller label.
struct Outbox {
  std::vector<std::vector<Term>> by_partition;
  SumCounts counts;
};

// Follows the gaps that start at one vertex.
class Sweep {
 public:
  Sweep(const Arrangement2& arrangement, const Labels2& labels, int partition_shift)
      : arrangement_(arrangement), labels_(labels), partition_shift_(partition_shift) {}

  void operator()(VertexId v, View2& view, Outbox& out) const {
    const Vertices2& vertices = arrangement_.vertices();
    look_around(vertices, arrangement_.triangulation(), v, view);
    for_each_gap(vertices, v, view, true, [&](const Gap2& gap) {
      ++out.counts.gaps;
      FixedLength length{0, false};
      bool is_measured = false;
      for_each_term(gap, labels_, [&](std::uint32_t i, std::uint32_t j, int sign) {
        if (!is_measured) {
          length = vertices.distance(gap.v, gap.w);
          is_measured = true;
        }
        ++out.counts.updates;
        const Int128 value = i == j ? 2 * length.value : length.value;
        const bool is_obstructed = !((is_end(i, gap.v) || is_end(j, gap.v)) && (is_end(i, gap.w) || is_end(j, gap.w)));
        out.by_partition[std::min(i, j) >> partition_shift_].push_back(
            {key_of(i, j), length.is_exact ? 0u : (i == j ? 2u : 1u), is_obstructed, sign > 0 ? value : -value});
      });
    });
  }

 private:
  bool is_end(std::uint32_t label, VertexId v) const { return label != labels_.sky() && labels_.has_end(label, v); }

  const Arrangement2& arrangement_;
  const Labels2& labels_;
  const int partition_shift_;
};

}  // namespace

std::vector<PairSum> sum_visible_pairs(const Arrangement2& arrangement, const Labels2& labels,
                                       const std::function<void(double)>& progress, std::uint64_t most_pairs,
                                       SumCounts& counts) {
  const std::size_t label_count = labels.count() + 1;  // the sky too
  int partition_shift = 0;
  while ((label_count >> partition_shift) > 64) ++partition_shift;
  const std::size_t partitions = ((label_count - 1) >> partition_shift) + 1;

  std::vector<PairTable> tables(partitions);
  tbb::enumerable_thread_specific<Outbox> outboxes([partitions] {
    return Outbox{std::vector<std::vector<Term>>(partitions), {}};
  });
  const Sweep sweep(arrangement, labels, partition_shift);

  // Rounds: sweep some vertices, then empty the outboxes into the tables. A round is as large as keeps the terms in
  // flight near kTermsInFlight, judged by the round before.
  constexpr std::size_t kTermsInFlight = 1 << 19;
  const std::size_t n = arrangement.vertices().size();
  std::size_t round = 64;
  for (std::size_t begin = 0; begin < n;) {
    const std::size_t end = std::min(n, begin + round);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(begin, end, 8),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                        Outbox& out = outboxes.local();
                        thread_local View2 view;
                        for (std::size_t v = range.begin(); v != range.end(); ++v)
                          sweep(static_cast<VertexId>(v), view, out);
                      });
    std::size_t in_flight = 0;
    for (const Outbox& out : outboxes)
      for (const auto& terms : out.by_partition) in_flight += terms.size();
    tbb::parallel_for(std::size_t{0}, partitions, [&](std::size_t partition) {
      for (Outbox& out : outboxes) {
        for (const Term& term : out.by_partition[partition]) tables[partition].add(term);
        out.by_partition[partition].clear();
      }
    });
    std::uint64_t pairs = 0;
    for (const PairTable& table : tables) pairs += table.size();
    if (pairs > most_pairs)
      throw RequestError(fmt::format(
          "the scene has more than {} visible pairs, which is all that the memory allowed holds", most_pairs));
    round = std::clamp<std::size_t>(round * kTermsInFlight / (in_flight + 1), std::max<std::size_t>(16, round / 4),
                                    4 * round);
    begin = end;
    if (progress) progress(static_cast<double>(begin) / static_cast<double>(n));
  }
  for (const Outbox& out : outboxes) {
    counts.gaps += out.counts.gaps;
    counts.updates += out.counts.updates;
  }

  std::vector<std::vector<PairSum>> sorted(partitions);
  tbb::parallel_for(std::size_t{0}, partitions,
                    [&](std::size_t partition) { sorted[partition] = tables[partition].take(); });
  std::size_t total = 0;
  for (const auto& part : sorted) total += part.size();
  std::vector<PairSum> result;
  result.reserve(total);
  for (auto& part : sorted) {
    result.insert(result.end(), part.begin(), part.end());
    std::vector<PairSum>().swap(part);
  }
  return result;
}

std::uint64_t estimated_pairs(const Arrangement2& arrangement, const Labels2& labels) {
  // Pairs that see each other through one opening have four terms; there are few with less.
  constexpr std::uint64_t kTermsPerPair = 4;
  constexpr std::uint64_t kSample = 256;
  const std::uint64_t n = arrangement.vertices().size();
  std::mt19937_64 random(1);
  const std::uint64_t sample = std::min(kSample, n);
  std::uint64_t terms = 0;
  View2 view;
  for (std::uint64_t k = 0; k < sample; ++k) {
    const auto v = static_cast<VertexId>(sample == n ? k : random() % n);
    look_around(arrangement.vertices(), arrangement.triangulation(), v, view);
    // Every gap is met from both its ends: half of it belongs to this one.
    for_each_gap(arrangement.vertices(), v, view, false, [&](const Gap2& gap) {
      for_each_term(gap, labels, [&terms](std::uint32_t, std::uint32_t, int) { ++terms; });
    });
  }
  return sample == 0 ? 0 : terms * n / (2 * kTermsPerPair * sample);
}

Int128 closure_defect(const std::vector<PairSum>& pairs, const Labels2& labels) {
  std::vector<Int128> sum(labels.count() + 1, 0);
  for (const PairSum& pair : pairs) {
    sum[pair.i] += pair.value;
    if (pair.j != pair.i) sum[pair.j] += pair.value;
  }
  Int128 defect = 0;
  for (std::uint32_t label = 0; label < labels.count(); ++label) {
    if (!labels.has_row(label)) continue;
    const Int128 difference = sum[label] - 2 * labels.length(label).value;
    defect = std::max(defect, difference < 0 ? -difference : difference);
  }
  return defect;
}

}  // namespace hottel

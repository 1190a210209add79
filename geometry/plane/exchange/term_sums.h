// The terms of many gaps, summed by pair of labels, in parallel and in an order of its own.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "geometry/pair_table.h"
#include "geometry/plane/predicates/vertices.h"
#include "geometry/shared_work.h"
#include "kernel/int128.h"
#include "kernel/rounding.h"

namespace hottel {

// Returns the key of an unordered pair of labels.
//
//   (1) pair_key(i, j) == pair_key(j, i), and different pairs have different keys
//   (2) keys ascend by the smaller label, then by the larger one
constexpr std::uint64_t pair_key(std::uint32_t i, std::uint32_t j) {
  return i <= j ? (static_cast<std::uint64_t>(i) << 32) | j : (static_cast<std::uint64_t>(j) << 32) | i;
}
// The two labels of a key.
constexpr std::uint32_t smaller_label(std::uint64_t key) { return static_cast<std::uint32_t>(key >> 32); }
constexpr std::uint32_t larger_label(std::uint64_t key) { return static_cast<std::uint32_t>(key); }

// A term of 2 S(i, j) in fixed point, or the sum of some of them.
//
//   (1) any order of addition gives the same sum, bit for bit: integers are added modulo 2^128
//   (2) is_obstructed is 1 as soon as it is 1 in one term of the sum
//
// REQUIRES: the final sum of a pair fits into 128 bits. Sums on the way need not.
struct PairSum2 {
  static constexpr bool kOrderMatters = false;
  std::uint64_t key = 0;                // pair_key(i, j)
  std::uint64_t inexact : 63 = 0;       // how many of the lengths added were rounded
  std::uint64_t is_obstructed : 1 = 0;  // a vertex that is no end of i or j took part: only then can j be hidden from i
  Int128 value = 0;                     // in units of Vertices2::fixed_unit()

  std::uint32_t i() const { return smaller_label(key); }
  std::uint32_t j() const { return larger_label(key); }
  FixedSum sum(double length_error) const { return {value, static_cast<double>(inexact) * length_error}; }

  void add(const PairSum2& term) {
    // Only the final sum is bounded: on the way it may wrap around.
    value = static_cast<Int128>(static_cast<UInt128>(value) + static_cast<UInt128>(term.value));
    inexact += term.inexact;
    is_obstructed |= term.is_obstructed;
  }
};

// A term in plain doubles: the sum depends on the order of addition, which sum_terms() fixes.
struct PlainTerm2 {
  static constexpr bool kOrderMatters = true;
  std::uint64_t key;
  double value;

  std::uint32_t i() const { return smaller_label(key); }
  std::uint32_t j() const { return larger_label(key); }
  void add(const PlainTerm2& term) { value += term.value; }
};

// Where a sweep leaves its terms: by partition of the smaller label. Partition k takes the labels from k * 2^shift on,
// 2^shift of them. Where order does not matter, terms of one key that come soon after each other are added up before:
// those of the two ends of an element are, and so is what stays the same from one gap to the next.
//
//   (1) after flush() the terms in the partitions have the sums of all that were added
// REQUIRES: every smaller label falls into one of the partitions.
template <class Term>
class TermBuffer2 {
 public:
  TermBuffer2(std::size_t partitions, int shift) : by_partition_(partitions), shift_(shift) {
    if (!Term::kOrderMatters) clear_recent();
  }

  void add(const Term& term) {
    if (Term::kOrderMatters) return leave(term);
    Term& recent = recent_[spread_key(term.key, 64 - kRecentBits)];
    if (recent.key == term.key) return recent.add(term);
    if (recent.key != kNoKey) leave(recent);
    recent = term;
  }
  void flush() {
    for (Term& recent : recent_)
      if (recent.key != kNoKey) {
        leave(recent);
        recent.key = kNoKey;
      }
  }
  std::vector<Term>& partition(std::size_t k) { return by_partition_[k]; }
  std::size_t size() const {
    std::size_t size = 0;
    for (const auto& terms : by_partition_) size += terms.size();
    return size;
  }

  std::uint64_t gaps = 0, updates = 0;  // counted by the sweep

 private:
  static constexpr int kRecentBits = 12;  // with terms of 32 bytes they stay in the second cache
  static constexpr std::size_t kRecent = std::size_t{1} << kRecentBits;
  static constexpr std::uint64_t kNoKey = PairTable<Term>::kEmptyKey;

  void clear_recent() {
    recent_.resize(kRecent);
    for (Term& recent : recent_) recent.key = kNoKey;
  }
  void leave(const Term& term) { by_partition_[term.key >> (32 + shift_)].push_back(term); }

  std::vector<std::vector<Term>> by_partition_;
  std::vector<Term> recent_;
  int shift_;
};

struct SumCounts2 {
  std::uint64_t gaps = 0;     // pairs of vertices that see each other
  std::uint64_t updates = 0;  // terms added
};

// What the sweeps of some vertices added up to: those of the places [begin, end) of the order.
template <class Term>
struct SweptPart {
  std::size_t begin = 0, end = 0;
  SumCounts2 counts;
  std::vector<Term> sums;  // by key
};

// Parts of a sweep that were swept before, and who gets those that are swept now: every few seconds, where a part from
// before begins, in the end unless all took less, and before a failure or a stop.
template <class Term>
struct SweepParts {
  std::vector<SweptPart<Term>> before;  // of the same order; of two with a place in common one is taken
  std::function<void(SweptPart<Term>&&)> sink = {};
  std::chrono::duration<double> between{2};
};
using SweptPart2 = SweptPart<PairSum2>;
using SweepParts2 = SweepParts<PairSum2>;

// Leaves the terms of one vertex in the buffer, and counts its gaps and updates there.
template <class Term>
using TermSweep = std::function<void(VertexId, TermBuffer2<Term>&)>;

// Calls sweep(v, buffer) for each vertex v of `order` and sums the terms by key. Returns the sums in partitions, each
// sorted by key; taken one after the other they are sorted as a whole.
//
//   (1) each key occurs once, and only where a term was added
//   (2) the terms of a key are added in the order of the vertices given and, for one vertex, of the buffer, for any
//       number of threads: sums of doubles are the same bit for bit
//   (3) `counts` grows by what the sweeps counted
//   (4) with `parts` those that were swept before are not swept again: the same sums, as order does not matter.
//       REQUIRES that it does not
//   (5) with `work` others sweep some of the places, which are its tasks: the same sums. Each is swept once: else
//       ContractViolation. REQUIRES that order does not matter, and that there are no parts
//
// `sweep` is called from several threads at once, for different vertices and with different buffers. `progress` is
// called from time to time, on the calling thread, with the fraction done; it may throw to stop.
// Throws RequestError when the pairs become more than `most_pairs`; this is looked at after each round of vertices.
// REQUIRES: labels >= 1, and every smaller label of a term is below `labels`.
// COST: parallel; once or twice the size of a term for each term in flight, 1.3 to 2.7 times for each pair.
template <class Term>
std::vector<std::vector<Term>> sum_terms(std::span<const VertexId> order, std::size_t labels,
                                         const TermSweep<Term>& sweep, const std::function<void(double)>& progress,
                                         std::uint64_t most_pairs, SumCounts2& counts,
                                         SweepParts<Term>* parts = nullptr,
                                         SharedWork<SweptPart<Term>>* work = nullptr);

extern template std::vector<std::vector<PairSum2>> sum_terms(std::span<const VertexId>, std::size_t,
                                                             const TermSweep<PairSum2>&,
                                                             const std::function<void(double)>&, std::uint64_t,
                                                             SumCounts2&, SweepParts<PairSum2>*,
                                                             SharedWork<SweptPart<PairSum2>>*);
extern template std::vector<std::vector<PlainTerm2>> sum_terms(std::span<const VertexId>, std::size_t,
                                                               const TermSweep<PlainTerm2>&,
                                                               const std::function<void(double)>&, std::uint64_t,
                                                               SumCounts2&, SweepParts<PlainTerm2>*,
                                                               SharedWork<SweptPart<PlainTerm2>>*);

}  // namespace hottel

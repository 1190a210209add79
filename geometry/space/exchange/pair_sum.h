// Direct exchange areas of pairs of elements, with requests and reports.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/element.h"
#include "geometry/pair_ranges.h"
#include "geometry/space/exchange/exchange_report.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "kernel/enclosure.h"

namespace hottel {

// S of two elements, i <= j, or of an element and the sky: the sum over their patches, in the unit of PairIntegrator3.
struct PairSum3 {
  std::uint32_t i, j;
  double measure = 0, error = 0;  // |measure - S| <= error, an estimate; may be 0 where S is not
  Enclosure bounds{0, 0};         // of S, proven
  double alone = 0;               // S0, each patch measured alone; 0 with the sky, and of groups until measure_alone()
  bool is_whole = true;           // nothing hides any patch from another: S = S0

  bool is_zero() const { return bounds.upper == 0; }  // S = 0
  friend bool operator==(const PairSum3&, const PairSum3&) = default;
};

// Two elements that could not be measured within the tolerance.
struct FailedPair3 {
  std::uint32_t i, j;
  double reached;       // the tolerance that was, relative to the smaller area
  bool is_undecided;    // whether they see each other could not be decided; then `reached` means nothing
  std::string problem;  // why, of one pair of their patches
};

// The pairs that are measured in one turn: at least one of the two elements is in this turn, neither was in a turn
// before, and the pair is not known already. Pairs with the sky may be limited to some elements. Lists are by label,
// the sky last.
struct PairTurn3 {
  const std::vector<char>& is_now;
  const std::vector<char>& was_before;
  const PairRanges* known = nullptr;            // null: none are
  const std::vector<char>* with_sky = nullptr;  // null: all
  bool is_of_sky_alone = false;                 // no other pairs

  // REQUIRES i <= j.
  bool has(std::uint32_t i, std::uint32_t j) const {
    const bool is_sky = j + std::size_t{1} == is_now.size();
    if (is_sky ? with_sky != nullptr && (*with_sky)[i] == 0 : is_of_sky_alone) return false;
    return (is_now[i] != 0 || is_now[j] != 0) && was_before[i] == 0 && was_before[j] == 0 &&
           (known == nullptr || !known->has(i, j));
  }
};

// Gets pairs of elements that are done while others are still being measured, as PairHandover3 says, on any thread. It
// may change the pairs, and may throw to stop.
using PairSink3 = std::function<void(std::span<PairSum3> pairs, const PairRanges& known)>;

// What is asked.
struct PairSumRequest3 {
  double tolerance = 1e-9;        // as PairRequest3
  bool proves = false;            // as PairRequest3
  bool wants_visibility = false;  // PairSum3::alone and is_whole; else alone is 0 and is_whole means nothing
  std::uint64_t most_pairs = std::numeric_limits<std::uint64_t>::max();  // beyond: RequestError
  std::function<void(double)> progress = {};  // fraction done, from any thread; may throw to stop
  const PairTurn3* turn = nullptr;            // these pairs alone; null: all
  std::optional<Granularity> shared = {};     // of the table; where it is told PairCrew3 may take part
  PairSink3 sink = {};                        // gets pairs that are done; before a failure or a stop, all of them
  bool has_sink_alone = false;                // what it gets is not returned as well
  std::chrono::duration<double> between{2};   // the time between its calls
};

struct PairSums3 {
  std::vector<PairSum3> pairs;        // by (i, j), the sky last
  std::vector<FailedPair3> failures;  // by (i, j)
};

}  // namespace hottel

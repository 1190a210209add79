// The exchange measures of all pairs of elements.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "geometry/pair_ranges.h"
#include "geometry/space/exchange/element_table.h"
#include "geometry/space/exchange/exchange_report.h"
#include "geometry/space/exchange/prepared_scene.h"
#include "kernel/enclosure.h"

namespace hottel {

// S of two elements, i <= j, or of one and the sky: the sum over their patches, in the unit of PairMeasurer3.
struct PairSum3 {
  std::uint32_t i, j;
  double measure = 0, error = 0;  // |measure - S| <= error, an estimate; may be 0 where S is not
  Enclosure bounds{0, 0};         // of S, proven
  double alone =
      0;  // S0 where each patch is measured with nothing else there; 0 of the sky; of groups until measure_alone()
  bool is_whole = true;  // nothing hides any patch from another: S = S0

  bool is_zero() const { return bounds.upper == 0; }  // S = 0
  friend bool operator==(const PairSum3&, const PairSum3&) = default;
};

// A pair of patches, by the elements that they are of, that could not be measured.
struct FailedPair3 {
  std::uint32_t i, j;
  std::string problem;
};

// Some pairs of all: those of which one element at least is called up, and none was before, and that are not known from
// elsewhere. By label, the sky last.
struct PairTurn3 {
  const std::vector<char>& is_now;
  const std::vector<char>& was_before;
  const PairRanges* known = nullptr;  // null: none are

  // REQUIRES i <= j.
  bool has(std::uint32_t i, std::uint32_t j) const {
    return (is_now[i] != 0 || is_now[j] != 0) && was_before[i] == 0 && was_before[j] == 0 &&
           (known == nullptr || !known->has(i, j));
  }
};

// What is asked.
struct PairSumRequest3 {
  double tolerance = 1e-9;        // as PairRequest3
  bool wants_visibility = false;  // PairSum3::alone and is_whole; else alone is 0 and is_whole means nothing
  std::uint64_t most_pairs = std::numeric_limits<std::uint64_t>::max();  // beyond: RequestError
  std::function<void(double)> progress = {};  // fraction done, from any thread; may throw to stop
  const PairTurn3* turn = nullptr;            // these pairs alone; null: all
};

struct PairSums3 {
  std::vector<PairSum3> pairs;        // by (i, j), the sky last
  std::vector<FailedPair3> failures;  // by (i, j)
};

// Measures all pairs of patches of which at least one is of an element with a row, and sums them by elements.
//
//   (1) a pair is there iff S > 0; of groups with visibilities also where S = 0 < S0 of some patches: then S = 0
//   (2) the same bit for bit for any number of threads: patches are summed in their order
//   (3) a pair (i, i), of a group, counts both directions of a line
//   (4) contacts of masks are pairs like others: whole, and as large as what they share
//   (5) adds to the hidden, clear and mixed pairs, the maps, pieces, nodes and signs of the report
//
// Throws Interrupted where it is asked to stop.
// COST: parallel; that of measuring each pair of faces that face each other, and 50 ns for each other pair.
PairSums3 sum_pairs(const PreparedScene3& prepared, const ElementTable3& table, const PairSumRequest3& request,
                    ExchangeReport3& report);

// Gives elements whose pair with the sky could not be measured what their other pairs leave of their areas, where that
// is known within the tolerance, and more than its error: their rows then close by definition. Next to a small thing,
// or one that is very far from the others, doubles have too few digits for the far walls of the sky, and enough for
// these. REQUIRES all pairs of these elements, in order.
void take_rest_for_sky(const ElementTable3& table, double tolerance, PairSums3& sums);

// Returns about how many pairs of patches exchange light, from 512 drawn by a fixed seed and measured. The same scene
// always gives the same estimate. It may be wrong either way.
std::uint64_t estimated_pairs(const PreparedScene3& prepared, const ElementTable3& table);

}  // namespace hottel

// What is asked of a pair of patches, and the answer.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "geometry/space/between/pair_visibility.h"
#include "geometry/space/proven/proof_counts.h"
#include "kernel/determinant.h"
#include "kernel/enclosure.h"

namespace hottel {

// How much is tried. kAll: where a number does not come within the tolerance, or fails a check, it is computed again
// with more digits and in more parts.
enum class Effort3 : unsigned char { kUsual, kAll };

// What is asked of a pair.
struct PairRequest3 {
  // How far S may be off, relative to the smaller of both areas.
  double tolerance = 1e-9;
  // The same in the unit of measures; where it is given, `tolerance` means nothing.
  std::optional<double> share = {};
  Effort3 effort = Effort3::kAll;
  // Whether narrow bounds are proven for sums along edges too: as a rule as narrow as the tolerance. The measure stays
  // the same, unless the proof gives a better one. COST: some times that of the measure.
  bool proves = false;
  // For tests: integrate along the edges from j to i; settle every pair along edges, also where it is clear; take
  // another origin for moments (in the unit of doubles, added to the usual one; where both patches reach the plane of
  // each other the origin is on the line that both planes share, and moves along it by the first number times what
  // patch i has of it).
  bool is_reversed = false;
  bool always_along_edges = false;
  double origin_shift[3] = {0, 0, 0};
  // For tests: if false, everything that may stand between is walked, even if hiders would settle the pair at once.
  bool asks_hiders = true;
};

// The direct exchange area of a pair: S = A_i F_ij = A_j F_ji. Lengths are those of the doubles of Vertices3 (integer
// form times 2^-shift), areas their squares.
//
//   (1) S = 0 and S = S0 (is_whole: nothing between them hides anything) are decided by signs; measure is 0 iff S is.
//       Where is_undecided, they could not be
//   (2) |measure - S| <= error. This is an estimate: the difference of two quadratures, rounding, and what parts of
//       edges that are too short to be looked at may add. For a part that is bounded and not integrated it is half the
//       width of its bounds
//   (3) bounds enclose S: proven. For sums along edges they are wide unless the request `proves`
//   (4) where problem is empty, error is within what is allowed; else it is more, and problem says why. A number that
//       failed the residual of translation is left out: only its bounds are given
struct PairResult3 {
  PairVisibility3 sight = PairVisibility3::kHidden;
  bool is_whole = false, is_undecided = false;
  double measure = 0, error = 0;
  Enclosure bounds{0, 0};
  double alone = 0;  // S0, within what is allowed, where it came out on the way; else 0
  double residual = 0, residual_bound = 0;
  std::string problem;
  // How the number came about.
  std::uint32_t maps = 0, pieces = 0, nodes = 0;
  SignCounts signs;
  ProofCounts3 proof;
};

}  // namespace hottel

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

// How much is tried. kAll: where numbers do not come within what is allowed, or fail a check, with more digits, and cut
// in more parts.
enum class Effort3 : unsigned char { kUsual, kAll };

// What is asked of a pair.
struct PairRequest3 {
  // What S may be off, relative to the smaller of both areas.
  double tolerance = 1e-9;
  // The same in the unit of measures, where it is given: then `tolerance` means nothing.
  std::optional<double> share = {};
  Effort3 effort = Effort3::kAll;
  // Whether bounds are to be proven of sums along edges too: then they are as narrow as the tolerance, as a rule. The
  // measure is the same but where it is told better so. COST: some times that of the measure.
  bool proves = false;
  // For tests: integrate along the edges from j to i; settle every pair along edges, also where it is clear; take
  // another origin for moments (in the unit of doubles, added to the usual one; where both patches reach the plane of
  // each other the origin is on the line that both planes share, and moves along it by the first number times what
  // patch i has of it).
  bool is_reversed = false;
  bool always_along_edges = false;
  double origin_shift[3] = {0, 0, 0};
  // For tests: else everything that may stand between is walked, whether or not it is told at once what is hidden.
  bool asks_hiders = true;
};

// The direct exchange area of a pair: S = A_i F_ij = A_j F_ji. Lengths are those of the doubles of Vertices3 (integer
// form times 2^-shift), areas their squares.
//
//   (1) S = 0 and S = S0 (is_whole: nothing between them hides anything) are decided by signs; measure is 0 iff S is.
//       Where is_undecided, they could not be
//   (2) |measure - S| <= error: an estimate, what two quadratures differ by, and rounding; or, of what is bounded
//       instead of integrated, half of what is between its bounds
//   (3) bounds enclose S: proven. Of sums along edges they are wide unless the request `proves`
//   (4) where problem is empty, error is within what is allowed; else it is more, and problem says why. A number that
//       failed the residual of translation is not told: what is told then are bounds
struct PairResult3 {
  PairVisibility3 sight = PairVisibility3::kHidden;
  bool is_whole = false, is_undecided = false;
  double measure = 0, error = 0;
  Enclosure bounds{0, 0};
  double alone = 0;  // S0, within what is allowed, where it was told on the way; else 0
  double residual = 0, residual_bound = 0;
  std::string problem;
  // How the number came about.
  std::uint32_t maps = 0, pieces = 0, nodes = 0;
  SignCounts signs;
  ProofCounts3 proof;
};

}  // namespace hottel

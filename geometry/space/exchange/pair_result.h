// What is asked of a pair of patches, and the answer.
#pragma once

#include <cstdint>
#include <string>

#include "geometry/space/exchange/sight.h"
#include "kernel/determinant.h"
#include "kernel/enclosure.h"

namespace hottel {

// What is asked of a pair.
struct PairRequest3 {
  // What S may be off, relative to the smaller of both areas.
  double tolerance = 1e-9;
  // For tests: integrate along the edges from j to i; settle every pair along edges, also where it is clear; take
  // another origin for moments (in the unit of doubles, added to the usual one; where both patches reach the plane of
  // each other the origin is on the line that both planes share, and moves along it by the first number times what
  // patch i has of it).
  bool is_reversed = false;
  bool always_along_edges = false;
  double origin_shift[3] = {0, 0, 0};
};

// The exchange measure of a pair: S = A_i F_ij = A_j F_ji. Lengths are those of the doubles of Vertices3 (integer form
// times 2^-shift), areas their squares.
//
//   (1) S = 0 and S = S0 (is_whole: nothing between them hides anything) are decided by signs; measure is 0 iff S is
//   (2) |measure - S| <= error, an estimate: what two quadratures differ by, and rounding
//   (3) bounds enclose S: proven
//   (4) where problem is empty, error <= tolerance * min(A_i, A_j), and the residual of translation is within its own
//       bound; else the pair has failed, and problem says why
struct PairMeasure3 {
  Sight3 sight = Sight3::kHidden;
  bool is_whole = false;
  double measure = 0, error = 0;
  Enclosure bounds{0, 0};
  double residual = 0, residual_bound = 0;
  std::string problem;
  // How the number came about.
  std::uint32_t maps = 0, pieces = 0, nodes = 0;
  SignCounts signs;
};

}  // namespace hottel

// Whether errors that scatter as those of rays lean as well: tested by columns, by rows and as a whole.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "solver/compare/judged_pairs.h"
#include "solver/compare/scattered_pairs.h"

namespace hottel {

// A sum of factors that is further from the exact one than scatter allows.
struct SamplingBias {
  std::string words;    // "hits on 'box' are short by 10 %"
  double relative = 0;  // of the exact sum: -0.1 is ten per cent short
  double chance = 1;    // at most, that unbiased rays do so in any of the sums that were tested
};

// What the sums of rows tell. A counter that counts every ray has sums that are exact; one that loses some has not.
struct RowClosure {
  std::size_t exact = 0, off = 0;  // of rows with two pairs off or more, of which the file has all columns
  double most = 0;                 // the largest defect
};

struct NoiseBias {
  std::vector<SamplingBias> sums;  // the surest first, no two with a column or a row in common
  RowClosure rows;
  bool is_leaky = false;  // more rows are exact than chance would have it, as of a counter, and others are not

  bool is_biased() const { return is_leaky || !sums.empty(); }
};

// The level of significance: the chance that rays without bias are called biased, over all sums of a matrix.
inline constexpr double kBiasLevel = 1e-3;

// True iff A_i F_ij = A_j F_ji holds to the digits for all of these pairs, two at least.
bool is_symmetric(const JudgedPairs& judged, std::span<const ScatteredPair> pairs);

// Tests the sums of errors against what rays scatter: hits on each element, face and group that have a name of their
// own (columns), all that leaves each (rows, where they are not exact), all there are, the factors of partly hidden
// pairs, and the large ones.
//
//   (1) sums are told only where the chance of any of them, over all that are tested (Bonferroni), is below kBiasLevel;
//       where some rows are exact and others not, so that there is a bias for sure, below 0.05. That of one is
//       Bernstein's 2 exp(-T² / 2 / (V + T/3N)), which holds however few the hits are
//   (2) V is that of rests: losses do not widen it. Rows that scatter more than others, and columns, count with
//       what they scatter themselves
//   (3) where A_i F_ij = A_j F_ji holds to the digits, each pair is one number and the tests are of their signs: of
//       sums T over the root of the sum of the squares
// pairs: as scattered_pairs() returns them; scale, rays: of what they scatter. COST: a few passes over the pairs.
NoiseBias noise_bias(const JudgedPairs& judged, std::span<const ScatteredPair> pairs, RaySpread spread, double scale,
                     double rays);

}  // namespace hottel

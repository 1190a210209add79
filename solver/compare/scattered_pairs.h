// Errors that may be scatter, and how much of them is left once what goes with rows and columns is taken off.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "solver/compare/judged_pairs.h"

namespace hottel {

// A pair whose factor may scatter.
struct ScatteredPair {
  const JudgedPair* pair = nullptr;
  double error = 0;     // value - exact
  double variance = 0;  // of one ray: N have the N-th part (even ones: the N^(3/2)-th)
  double rest = 0;      // of the error, without what goes with its row and its column
};

// How rays are spread: at random, or evenly over places and directions (stratified, Sobol), of which only those of
// cells count that a border crosses.
enum class RaySpread { kRandom, kEven };

// Of one ray: F (1 - F) at random, its root where rays are spread evenly.
double variance_of_one(double exact, RaySpread spread);

// Returns the pairs with a factor between 0 and 1, without those that are left out (by place in judged.pairs(); empty:
// none), by rows. `rest` is what is left of e_ij after the best a_j F_ij + b_i F_ij, weighted by the variances: a loss
// that takes the same share of all hits on a face, or of all that leaves it, is in none of them.
//
// COST: a few passes over the pairs.
std::vector<ScatteredPair> scattered_pairs(const JudgedPairs& judged, const std::vector<char>& leave_out,
                                           RaySpread spread);

// How much rays scatter, from the rests.
struct ScatterScale {
  double scale = 0;    // variance_of_one over the mean square of a rest; 0: too few pairs to tell
  double freedom = 0;  // pairs less rows and columns
};

// Returns the scale by the median of the squares, so that a few pairs that are wrong otherwise do not count. `fewest`:
// expected hits of a pair that is counted; rays: N, as far as it is known. COST: one sort.
ScatterScale scatter_scale(std::span<const ScatteredPair> pairs, double rays, double fewest);

inline constexpr double kMedianOfSquares = 0.4549;  // of a standard normal number

}  // namespace hottel

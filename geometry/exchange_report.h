// Counts, times and checks of a computation of view factors.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "kernel/tier.h"

namespace hottel {

// How the numbers came about. Surfaces are those listed; vertices and pieces are those of the arrangement.
//
//   (1) pairs: unordered pairs of elements that exchange light, those with the sky among them
//   (2) gaps and terms: what the sweep looked at and added; 0 where no sweep was made
//   (3) seconds: "prepare", "label", "sweep" (or "strings" in a convex room), "round", "exact" where it
//       was needed, "matrix"
//
// exact_exchange() adds to the tiers of the report it is given, and sets the rest.
struct ExchangeReport {
  std::uint64_t surfaces = 0, vertices = 0, pieces = 0, elements = 0, pairs = 0, gaps = 0, terms = 0;
  TierCounts tiers;                       // one count a rounded number: factors both ways, visibilities
  bool closure_is_exact = false;          // the integer identity sum_j 2 S(i, j) = 2 A_i held in every row
  std::map<std::string, double> seconds;  // of stages that ran
};

// The first row is integrated to compare, and each after so many.
inline constexpr std::uint32_t kRowsOfASkyCheck = 32;

// What elements see of the sky where it is what all others leave of their areas (SkyBy::kClosure).
//
//   (1) told: so many rows have it from their sums; checked: so many have it by integration, to compare: every
//       32nd row; integrated: so many others have too, as the rest of their rows cannot be told from
//       nothing within the tolerances of their pairs
//   (2) max_error: the largest sum of the errors that the pairs of a row state, of rows that are told; within: what
//       those of a row may be at most, n pairs times the tolerance. Both over the area
//   (3) max_difference: the largest that a checked row has between rest and integral, over the area; of the row
//       `farthest`. beyond: so many differ by more than what their pairs state. None does by more than they may
struct SkyByClosure {
  std::uint64_t told = 0, checked = 0, integrated = 0, beyond = 0;
  double max_error = 0, within = 0, max_difference = 0;
  std::string farthest;  // empty where max_difference is 0
};

}  // namespace hottel

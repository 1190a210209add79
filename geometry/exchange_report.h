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

}  // namespace hottel

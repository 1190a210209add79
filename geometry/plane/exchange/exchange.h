// Exact view factors of a scene in the plane.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "geometry/exchange_matrix.h"
#include "geometry/plane/arrangement/arrangement.h"
#include "geometry/plane/exchange/exact_sums.h"
#include "geometry/plane/exchange/labels.h"
#include "kernel/root_sum.h"
#include "kernel/rounding.h"

namespace hottel {

// A scene overlaid and triangulated: what every method receives, and what visibility is asked of.
// COST: O((n + k) log n) for n edges with k contacts.
struct PreparedScene2 {
  Scene2 scene;
  Division division;
  Arrangement2 arrangement;
  double seconds = 0;  // what the preparation took
};

// Prepares a scene with the number of elements each surface asks for (needed for Per::kElement only; whole surfaces
// are cheaper otherwise). Throws InputError when claims on an overlap conflict.
enum class Divided : bool { kNo, kYes };
PreparedScene2 prepare(Scene2 scene, Divided divided = Divided::kNo);

struct ExchangeOptions2 {
  Per per = Per::kFace;
  bool wants_visibility = true;  // else FactorEntry::visibility is NaN
  bool wants_measures = false;   // ExchangeMatrix::measures()
  bool occlusion = true;         // false: nothing can hide anything (is_convex_room); no sweep is made
  std::uint64_t memory = 0;      // bytes the sums and the matrix may take; 0: no limit. Beyond: RequestError
  std::function<void(double)> progress = {};  // fraction of the sweep done; may throw to stop. No sweep, no call
};

// How the numbers came about.
struct ExchangeReport {
  std::uint64_t surfaces = 0, vertices = 0, pieces = 0, elements = 0, pairs = 0, gaps = 0, terms = 0;
  TierCounts tiers;                       // one count a rounded number: factors both ways, visibilities
  bool closure_is_exact = false;          // the integer identity sum_j 2 S(i, j) = 2 A_i held in every row
  std::map<std::string, double> seconds;  // of stages that ran
};

// Returns the view factors of all pairs that exchange light, each correctly rounded.
//
//   (1) F_ij is the double nearest to the real view factor; its enclosure is at most one ulp wide
//   (2) no entry iff the real view factor is 0; this is decided without rounding
//   (3) A_i F_ij = A_j F_ji for the real numbers, and every row sums to 1, the sky included
//   (4) Vis(i, j) is correctly rounded too, but below 1 whenever something hides a part, and 1 when nothing does
//   (5) the result is the same bit for bit for any number of threads
//   (6) in a convex room it is the same bit for bit with and without occlusion
// COST: about 1 µs a visible pair and core; see benchmarks/results.
ExchangeMatrix exact_exchange(const PreparedScene2& prepared, const ExchangeOptions2& options = {},
                              ExchangeReport* report = nullptr);

// One pair in closed form, in scene units: S(i, j), S0(i, j), A_i, A_j as sums of square roots.
struct ExactPair2 {
  RootSum exchange, unobstructed, area_from, area_to;
};
ExactPair2 exact_pair(const PreparedScene2& prepared, Per per, std::uint32_t from, std::uint32_t to);
// The same for those who have the labels of `per` already.
ExactPair2 exact_pair(const PreparedScene2& prepared, const Labels2& labels, Per per, std::uint32_t from,
                      std::uint32_t to);

// Closed forms of many exchange measures S(i, j) at once, in scene units.
std::vector<RootSum> exact_exchange_measures(const PreparedScene2& prepared, Per per,
                                             const std::vector<LabelPair>& pairs);

// Areas of all labels in closed form, in scene units.
std::vector<RootSum> exact_areas(const PreparedScene2& prepared, Per per);

// Returns the pairs (from, to) that have a row and no entry in the matrix, but would exchange light if everything else
// were taken away (S = 0 < S0), sorted. What does not see the sky would: S0(i, sky) = A_i, so that Vis(i, sky) =
// F(i, sky). COST: every pair is looked at.
std::vector<LabelPair> hidden_pairs(const PreparedScene2& prepared, Per per, const ExchangeMatrix& matrix);

}  // namespace hottel

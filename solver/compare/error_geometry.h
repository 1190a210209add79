// Whether errors are scatter, or follow from where elements lie.
#pragma once

#include <algorithm>
#include <span>

#include "solver/compare/judged_pairs.h"
#include "solver/compare/judged_scene.h"
#include "solver/compare/scattered_pairs.h"

namespace hottel {

// How much of the squares of errors is shared by pairs that lie alike.
struct GeometricShare {
  double share = 0;        // in [-1, 1]: about 0 of rays, 1 of a rule
  double deviation = 1;    // that of rays would have, about 0
  bool is_closed = false;  // half of the rows, or more, sum to what they should

  // Scatter that also leans, or a few pairs that are wrong otherwise, keep below a third. Rows that do not sum to what
  // they should are no counter's, so that more is asked of them, and more numbers.
  bool is_geometry() const {
    if (is_closed) return share > std::max(kLeast, kDeviations * deviation);
    return share > std::max(kLeastOfOpen, kDeviations * deviation) || deviation > kMostOfOpen;
  }
  static constexpr double kLeast = 0.3, kDeviations = 2.5, kLeastOfOpen = 0.1, kMostOfOpen = 0.07;
};

// Returns the correlation of the errors, each divided by its standard deviation, of pairs with the pair that lies most
// alike: by the logarithms of distance and areas, both cosines, visibility. The error of a rule is a function of these
// where it is smooth, so that alike pairs have alike errors; those of rays are independent. A pair and its reverse are
// not compared, which may be one number.
//
// COST: 500 pairs against 20,000 at most.
GeometricShare geometric_share(const JudgedScene& scene, const JudgedPairs& judged,
                               std::span<const ScatteredPair> pairs);

}  // namespace hottel

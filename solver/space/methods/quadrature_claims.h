// How far quadrature over elements can be off between those that see each other wholly.
#pragma once

#include <optional>

#include "solver/space/methods/element_geometry.h"
#include "solver/space/methods/exchange_method.h"

namespace hottel {

// Over which areas a method takes a rule; over the other one, where there is one, it integrates exactly.
enum class RuleOver3 : unsigned char { kBoth, kFirst };

// A rule on patches: points in the patch whose weights are not below 0, exact for polynomials of that degree.
struct PatchRule3 {
  int degree = 0;
  RuleOver3 over = RuleOver3::kBoth;
};

// Returns a bound for |mean of x -> cos cos' / (pi r^2) over a, by the rule, less the true one|, for y anywhere in b;
// roundings included. Infinity where none can be told: unless each patch lies before the other, and b is farther from
// the centre of a than the corners of a are.                                          [1 / square of the unit]
//
// With v the way from the centre to a corner of a and d that to y, the kernel at s v is
//   (a d)(b (d - s v)) / (pi ((d - s v)^2)^2),      both zeros of (d - s v)^2 at |s| = |d| / |v|:
// analytic in |s| < |d| / |v|, and there at most h (|d| + |s v|) / (pi (|d| - |s v|)^4), h the height of y above a.
// What its Taylor polynomial of the rule's degree lacks at s = 1 follows (Cauchy's estimate), and a rule is off by
// twice as much at most.
double rule_error_3(const ElementPatch3& a, const ElementPatch3& b, int degree);

// What such a method may be off in the factors of two elements, or of one and the sky:
//
//   (1) proven for pairs of visibility 1, which is decided by signs; 0 for those that exchange nothing
//   (2) infinity for pairs that see a part of each other, and where rule_error_3 is
//   (3) of the sky: all that the others of the row are off together
// COST: that of the exact factors, once.
ExchangeMethod3::ClaimedErrors quadrature_claims_3(const PreparedScene3& prepared, const PatchRule3& rule);

// The largest of all pairs; nothing where one is infinity. COST: of scenes with walls that meet some 0.1 microseconds a
// pair of patches, else as above.
std::optional<double> quadrature_claim_3(const PreparedScene3& prepared, const PatchRule3& rule);

}  // namespace hottel

// Proven bounds on the solution of a radiosity system, for whatever approximation a solver gives.
#pragma once

#include <vector>

#include "solver/radiosity/approximate_inverse.h"
#include "solver/radiosity/radiosity_system.h"

namespace hottel {

// Of all that follows, `others` form some rows of residuals (row_crew.h; null: none do): the same bits with and
// without.

// Bounds of one solution: by unknown, each in a unit 2^exponent. That is the unit of its component, or one in which
// what is far darker than the brightest there is near 1.
struct CertifiedBounds {
  std::vector<DoubleDoubleBall> value;  // x_i
  std::vector<double> lower, upper;     // of the true radiosity; infinite when nothing could be proven
  std::vector<int> exponent;

  // The radiosity of an unknown, enclosed: x_i moved into its bounds, with a radius that reaches both. 0 if both are.
  ScaledBall enclosed(std::size_t unknown) const;
};

// Solves A x = r, the right side of each component brought near 1 first: none is solved by the scale of another.
Correction solve_by_component(const RadiositySystem& system, const ApproximateInverse& inverse, std::vector<double> r);

// Adds corrections to x, in each component until its residual is below its own error bound, or no longer falls. Returns
// max |residual| before each correction and after the last, each relative to the largest source of its component;
// `last` gets the enclosed residual of the x that it leaves.
// COST: one residual and one inner solve a step; two or three steps after an elimination.
std::vector<double> refine(const RadiositySystem& system, const Sources& sources, const ApproximateInverse& inverse,
                           SplitVector& x, std::vector<DoubleDoubleBall>* last = nullptr, SharedRows* others = nullptr);

// Encloses the solution of A B = E, given x near it.
//
// A is an M-matrix, so A^-1 >= 0, once a vector v > 0 has A v > 0 (which proves that the spectral radius of rho F is
// below 1). With w <= A v and the residual E - A x in [r-, r+]:
//   x + v min(0, min r-/w) <= B <= x + v max(0, max r+/w)          in each component.
// v solves A v = |r| approximately, so that the bounds are as wide as the residual's error bound makes them, and
// elements far from the light have bounds as narrow, relatively, as the others.
//
//   (1) the bounds hold whatever x is, whatever `inner` returns, and for any reflectivities with an exact loss
//   (2) no wider than Sources::range; else infinite upper bounds in components where A v > 0 could not be proven;
//       infinite ones on both sides everywhere when some factor is negative
//   (3) never wrong, but possibly infinite, when a reflectivity is so near 1 that the loss underflows
//   (4) with FactorsMeant::kWithinBounds they hold for all factors within their bounds whose rows sum to 1; where A v >
//       0 is not proven of that v, v = 1 is tried
// `residual`: that of x with these terms, where it is known (null: it is not).
// COST: two matrix passes, one where the residual is known, and one inner solve; up to twice as much again a further
// round when A v > 0 is not settled.
CertifiedBounds certify(const RadiositySystem& system, const Sources& sources, const ApproximateInverse& inverse,
                        const SplitVector& x, const ErrorTerms& terms = {},
                        const std::vector<DoubleDoubleBall>* residual = nullptr, SharedRows* others = nullptr);

// True iff the spectral radius of rho F is proven to be below 1 in all wanted components. COST: as certify().
bool spectral_radius_is_below_one(const RadiositySystem& system, const ApproximateInverse& inverse,
                                  const std::vector<char>& is_wanted, SharedRows* others = nullptr);

}  // namespace hottel

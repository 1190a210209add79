// Radiosities for any view factors and any sources within their enclosures.
#pragma once

#include <memory>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/material.h"
#include "solver/radiosity/factors_as_given.h"
#include "solver/radiosity/radiosity_options.h"
#include "solver/radiosity/radiosity_solution.h"
#include "solver/radiosity/radiosity_sources.h"

namespace hottel {

// Solves a matrix with enclosed entries by solving three: that of its doubles, of the lower ends of all bounds, of the
// upper. Sources that are enclosed are taken at their middle, their lower and their upper ends; unless all are
// narrower than 2^-48 of themselves, a few ulps: then one solution carries them as they are.
// All entries of (I - rho F)^-1 = I + rho F + (rho F)^2 + ... ascend with every factor, and so do radiosities and
// irradiances; they ascend with all sources too. What the lower and the upper ends give is therefore the smallest and
// the largest there is:
//
//   (1) lower <= B_i <= upper and net_lower <= net_i <= net_upper for all sources within their enclosures and for all
//       factors within theirs for which light dies out (spectral radius of rho F below 1); an upper bound that is
//       finite proves that it does for all of them
//   (2) no bounds of radiosities for all of these factors are narrower, but for the few ulps of the two solutions, and
//       up to twice the width of sources that are a few ulps wide
//   (3) where the matrix has closed rows and (1) is asked of such factors only, bounds are the narrower of these and of
//       those by the defects of rows (docs/design/radiosity.md), in which what is unknown of a factor counts times the
//       difference of two radiosities
//   (4) the radiosities of the doubles and of the middles are moved into these bounds, the irradiances are those of
//       what is then there
//   (5) `dark`, and a radiosity of exactly 0, is what no light reaches for any of these factors and sources
// REQUIRES that the matrix outlives this. COST: a solution, or three, or with closed rows four (five where sources are
// wide); for enclosed factors copies of the factors of two.
class EnclosedRadiosity {
 public:
  // `reflectivity`: by material.
  EnclosedRadiosity(const ExchangeMatrix& matrix, const std::vector<Spectrum>& reflectivity);
  ~EnclosedRadiosity();

  RadiositySolution solve(const RadiositySources& sources, const RadiosityOptions& options) const;

 private:
  struct Ends;

  const ExchangeMatrix& matrix_;
  FactorsAsGiven as_given_;
  bool has_closed_rows_;                       // and factors are enclosed
  std::unique_ptr<const Ends> lower_, upper_;  // where factors are enclosed
};

}  // namespace hottel

// Radiosities of view factors as they are, their enclosures left aside.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/material.h"
#include "solver/radiosity/radiosity_options.h"
#include "solver/radiosity/radiosity_solution.h"
#include "solver/radiosity/radiosity_sources.h"
#include "solver/radiosity/radiosity_system.h"

namespace hottel {

// Solves for the factors that the rows hold: real numbers where they are exact, else the doubles. As RadiositySolver
// says otherwise, but for the two defects of the matrix and the notes on faint radiosities.
//
//   (1) bounds hold for any sources within their enclosures, but are about twice as wide as they need be where those
//       are wider than roundings
// REQUIRES that the matrix outlives this. Throws as RadiositySystem does.
class FactorsAsGiven {
 public:
  // `reflectivity`: by material.
  FactorsAsGiven(const ExchangeMatrix& matrix, const std::vector<Spectrum>& reflectivity);
  ~FactorsAsGiven();

  // `may_be_open`: factors for which light need not die out are not refused, and leave bounds open instead. `terms`:
  // what of the certificate is left out, for tests that show that it is needed. REQUIRES DefaultFloatingPoint.
  RadiositySolution solve(const RadiositySources& sources, const RadiosityOptions& options, bool may_be_open,
                          const ErrorTerms& terms = {}) const;

 private:
  struct Group;
  struct Run;
  bool is_gray(const RadiositySources& sources) const;

  const ExchangeMatrix& matrix_;
  bool has_gray_reflectivities_;
  std::vector<std::unique_ptr<const Group>> groups_;  // by distinct reflectivities
};

}  // namespace hottel

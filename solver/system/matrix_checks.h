// What must balance: rows, pairs, and the light as a whole.
#pragma once

#include "geometry/exchange/exchange_matrix.h"
#include "solver/system/enclosed.h"
#include "solver/system/radiosity.h"

namespace hottel {

// max |sum_j F_ij - 1| over all rows, of the doubles.
double closure_defect(const ExchangeMatrix& matrix);

// max |A_i F_ij - A_j F_ji| / min(A_i, A_j) over all pairs of rows, of the doubles.
double reciprocity_defect(const ExchangeMatrix& matrix);

// Throws RequestError, naming what, where areas of rows, the sky's emission, the light of a solution or its power are
// too large to be written as doubles, or areas too small.
void require_doubles(const ExchangeMatrix& matrix, const Spectrum& sky_emission, const RadiositySolution& solution);

// The largest area of a row; 0 without rows.
double largest_area(const ExchangeMatrix& matrix);

// Sums the energy of a channel, row by row, without rounding that matters.
class EnergySum {
 public:
  explicit EnergySum(const ExchangeMatrix& matrix);

  // All per area; `absorbed` is (1 - reflectivity) irradiance.
  void add(std::uint32_t row, double emission, double absorbed, double radiosity, double sky_emission);

  EnergyBalance balance(int exponent) const;  // times 2^exponent

 private:
  const ExchangeMatrix& matrix_;
  int area_exponent_;  // areas are summed times 2^-area_exponent_
  Enclosed emitted_, absorbed_, to_sky_;
};

}  // namespace hottel

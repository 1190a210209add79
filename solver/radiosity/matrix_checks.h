// What must balance: rows, pairs, and the light as a whole.
#pragma once

#include "geometry/exchange_matrix.h"
#include "geometry/material.h"
#include "solver/radiosity/radiosity_solution.h"
#include "solver/radiosity/scaled_ball.h"

namespace hottel {

// max |sum_j F_ij - 1| over all rows, of the doubles.
double closure_defect(const ExchangeMatrix& matrix);

// max |A_i F_ij - A_j F_ji| / min(A_i, A_j) over all pairs of rows, of the doubles.
double reciprocity_defect(const ExchangeMatrix& matrix);

// Throws RequestError, naming what, where areas of rows, the sky's emission, the light of a solution or its power are
// too large to be written as doubles, or areas too small.
void require_doubles(const ExchangeMatrix& matrix, const Spectrum& sky_emission, const RadiositySolution& solution);

// Sums the energy of a channel, row by row, without rounding that matters.
class EnergySum {
 public:
  explicit EnergySum(const ExchangeMatrix& matrix) : matrix_(matrix) {}

  // All per area; `absorbed` is (1 - reflectivity) irradiance. Only the middles count.
  void add(std::uint32_t row, const ScaledBall& emission, const ScaledBall& absorbed, const ScaledBall& radiosity,
           const ScaledBall& sky_emission);

  EnergyBalance balance() const;

 private:
  const ExchangeMatrix& matrix_;
  ScaledBall emitted_, absorbed_, to_sky_;
};

}  // namespace hottel

// What must balance: rows, pairs, and the light as a whole.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/material.h"
#include "solver/radiosity/radiosity_solution.h"
#include "solver/radiosity/scaled_ball.h"

namespace hottel {

// Returns max |sum_j F_ij - 1| over all rows, of the doubles, the sky included; 0 without rows. The sums are
// formed to about 100 bits, so that they add nothing to the defect. COST: one pass, in parallel; the same for
// any number of threads.
double closure_defect(const ExchangeMatrix& matrix);

// Returns max |A_i F_ij - A_j F_ji| / min(A_i, A_j) over all pairs of rows, of the doubles; 0 without such pairs. A
// pair with one entry only counts with 0 for the other.
// COST: a search for each entry, in parallel; the same for any number of threads.
double reciprocity_defect(const ExchangeMatrix& matrix);

// What cannot be written as a double: a sentence, and the element whose it is, if it is that of one.
struct BeyondDoubles {
  std::string text;
  std::optional<std::uint32_t> element;
};

// Returns the first of areas of rows, the sky's emission, the light of a solution and its power that is too large to be
// written as a double, or an area that is too small; nothing where all can be.
std::optional<BeyondDoubles> beyond_doubles(const ExchangeMatrix& matrix, const Spectrum& sky_emission,
                                            const RadiositySolution& solution);

// Returns the first emission or reflectivity of a row that is not 0 and too small to be written as a double; nothing
// where there is none.
std::optional<BeyondDoubles> below_doubles(const ExchangeMatrix& matrix, const std::vector<Material>& materials);

// Throws RequestError where there is any (beyond_doubles).
void require_doubles(const ExchangeMatrix& matrix, const Spectrum& sky_emission, const RadiositySolution& solution);

// Sums the energy of a channel, row by row, without rounding that matters.
class EnergySum {
 public:
  explicit EnergySum(const ExchangeMatrix& matrix) : matrix_(matrix) {}

  // All per area; `absorbed` is (1 - reflectivity) irradiance. Only the middles count. What goes to elements without a
  // row counts as absorbed, what comes from the sky as emitted.
  void add(std::uint32_t row, const ScaledBall& emission, const ScaledBall& absorbed, const ScaledBall& radiosity,
           const ScaledBall& sky_emission);
  // Power that comes from no element and meets no row (PowerBesides). What is unaccounted for counts as emitted.
  void add_besides(const ScaledBall& absorbed, const ScaledBall& to_sky, const ScaledBall& unaccounted);

  // The sums so far, each rounded; `defect` is formed before they are.
  EnergyBalance balance() const;

 private:
  const ExchangeMatrix& matrix_;
  ScaledBall emitted_, absorbed_, to_sky_;
};

}  // namespace hottel

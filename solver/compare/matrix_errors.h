// How far a matrix of view factors is from the exact one.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/exchange_matrix.h"

namespace hottel {

// Taken over the ordered pairs that are present in either matrix: those with an entry in the exact one, or a factor
// other than 0 in the other. The sky is a column like any other.
struct MatrixErrors {
  double max = 0;      // max |F - exact F|
  double rms = 0;      // root of the mean of (F - exact F)²
  double closure = 0;  // max |sum_j F_ij - 1| of the matrix, over its rows
  std::uint64_t pairs = 0;
};

// One view factor, and what it should be.
struct PairError {
  std::uint32_t from = 0, to = 0;
  double value = 0, exact = 0;

  // |value - exact|; infinite when the value is no finite number.
  double error() const;
};

// Returns the errors of a matrix against the correctly rounded factors.
//
//   (1) all are 0 (closure: roundings of the sum) for the exact matrix itself
//   (2) pairs that neither has count nowhere: rms does not shrink because a scene is sparse
//   (3) a factor that is no finite number makes max and rms infinite
// REQUIRES: both are over the same elements. COST: one pass over both.
MatrixErrors matrix_errors(const ExchangeMatrix& matrix, const ExchangeMatrix& exact);

// Returns the pairs with the largest errors, worst first; equal ones in the order of the matrix; none without error.
//
//   (1) at most `count` pairs, each with error() > 0; a factor that is no finite number comes before all that are
// REQUIRES: both are over the same elements. COST: one pass over both, and a heap of `count` pairs.
std::vector<PairError> worst_pairs(const ExchangeMatrix& matrix, const ExchangeMatrix& exact, std::size_t count);

}  // namespace hottel

// How far a matrix of view factors is from the exact one.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "solver/compare/method_report.h"

namespace hottel {

// What a matrix does not have of what the exact one has.
struct MissingFactors {
  std::vector<std::uint32_t> rows;     // ascending: elements from which light goes, and of which there is no number
  std::vector<std::uint32_t> columns;  // ascending: elements, or the sky, to which light goes and that have no place
  std::uint64_t pairs =
      0;               // within the rows and columns that are there: 0, or left out, though the exact factor is not
  double largest = 0;  // exact factor of such a pair
};

// Taken over the ordered pairs that are present in either matrix, and that both have a place for: those with an entry
// in the exact one, or a factor other than 0 in the other. The sky is a column like any other. A pair that is left out
// where there is a place for it counts as 0.
struct MatrixErrors {
  double max = 0;      // max |F - exact F|
  double rms = 0;      // root of the mean of (F - exact F)²
  double closure = 0;  // max |sum_j F_ij - 1| of the matrix, over its rows; where columns are missing, what the exact
                       // factors of the others sum to stands for 1
  std::uint64_t pairs = 0;
  MissingFactors missing{};
  double max_of_others = 0;  // max over the pairs that are not missing
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
//   (4) rows and columns that `places` says are not there count in `missing` and nowhere else, those without an exact
//       factor nowhere; max, rms and closure are NaN where that leaves no pair at all
// REQUIRES: both are over the same elements. COST: one pass over both.
MatrixErrors matrix_errors(const ExchangeMatrix& matrix, const ExchangeMatrix& exact,
                           const WrittenFactors& places = {});

// Returns the pairs with the largest errors, worst first; equal ones in the order of the matrix; none without error.
//
//   (1) at most `count` pairs, each with error() > 0; a factor that is no finite number comes before all that are
//   (2) pairs that `places` has no place for are not among them
// REQUIRES: both are over the same elements. COST: one pass over both, and a heap of `count` pairs.
std::vector<PairError> worst_pairs(const ExchangeMatrix& matrix, const ExchangeMatrix& exact, std::size_t count,
                                   const WrittenFactors& places = {});

// What is missing, in words, without a full stop; empty where nothing is. exact: as the errors were taken against.
std::vector<std::string> missing_sentences(const MatrixErrors& errors, const ExchangeMatrix& exact);

}  // namespace hottel

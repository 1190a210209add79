// One method beside the exact one: how wrong, and how long.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "solver/compare/matrix_errors.h"
#include "solver/compare/method_report.h"
#include "solver/radiosity/radiosity_solution.h"

namespace hottel {

// What one method came to on one scene, held against the exact factors and radiosities.
//
//   (1) errors are those of `matrix` as it is: nothing is rescaled or completed before it is judged
//   (2) `solution` is nothing where max_radiosity_error is nothing or infinite
struct MethodResult {
  MethodInfo info;
  Timing timing;  // of the factors alone; the prepared scene is given to all
  MethodReport report;
  MatrixErrors errors;
  std::optional<double> declared_error;  // what the method had claimed of errors.max

  // max |B - exact B| / max |exact B|, over elements and channels; B is solved from the method's matrix as it is.
  //   infinite  the matrix has no solution that can be trusted (spectral radius not below 1); a note says so
  //   nothing   the exact matrix has none either: a room of perfect mirrors with a lamp
  //   0         neither is there any light
  std::optional<double> max_radiosity_error;

  std::uint64_t elements = 0;  // that have a row
  // The same of mean radiosities of whole faces, against those of a finer division (face_means.h), where there is one.
  std::optional<double> face_radiosity_error;

  ExchangeMatrix matrix;
  std::optional<RadiositySolution> solution;  // of that matrix
  std::vector<std::string> notes;             // the method's, then those of the comparison
};

// The errors of a result, of which plots and readings take one kind.
enum class ErrorKind : unsigned char {
  kMaxFactor,
  kRmsFactor,
  kRadiosity,     // max_radiosity_error
  kFaceRadiosity  // face_radiosity_error
};

// NaN where the result has none.
double error_of(const MethodResult& result, ErrorKind kind);

// Returns max |B - exact B| / max exact B, over all elements and channels of two solutions.
//
//   (1) 0 for equal solutions, also in the dark; infinite where only the exact one is dark, or a radiosity is no number
// REQUIRES the same elements and channels; throws ContractViolation when their numbers differ. COST: one pass.
double max_radiosity_error(const RadiositySolution& solution, const RadiositySolution& exact);

}  // namespace hottel

// Approximate methods beside the exact one, on one scene: how wrong, and how long.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "solver/compare/matrix_errors.h"
#include "solver/compare/timing.h"
#include "solver/plane/methods/exchange_method.h"
#include "solver/radiosity/radiosity.h"

namespace hottel {

// What one method came to.
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

  ExchangeMatrix matrix;
  std::optional<RadiositySolution> solution;  // of that matrix
  std::vector<std::string> notes;             // the method's, then those of the comparison
};

// max |B - exact B| / max |exact B| as in MethodResult. REQUIRES the same elements and channels.
double max_radiosity_error(const RadiositySolution& solution, const RadiositySolution& exact);

// A scene with its exact factors and radiosities, ready to judge methods.
class MethodComparison2 {
 public:
  // The scene, divided as its surfaces ask for, outlives this.
  explicit MethodComparison2(const PreparedScene2& prepared);

  // Throws RequestError when the method cannot be run on the scene. runs: as in time_repeatedly().
  MethodResult run(const ExchangeMethod2& method, const std::optional<int>& runs = {}) const;

  const PreparedScene2& prepared() const { return prepared_; }
  const ExchangeMatrix& exact() const { return exact_; }  // with visibilities
  const std::optional<RadiositySolution>& exact_solution() const { return exact_solution_; }
  const std::string& why_no_solution() const { return why_no_solution_; }

 private:
  std::optional<RadiositySolution> solve(const ExchangeMatrix& matrix, std::string& why_not) const;

  const PreparedScene2& prepared_;
  ExchangeMatrix exact_;
  std::string why_no_solution_;
  std::optional<RadiositySolution> exact_solution_;
};

// Adds the verdict in words to the notes of a result whose factors were read from a file or came from a command; does
// nothing to others. REQUIRES a result of this comparison, with its matrix. beyond: as in VerdictOptions.
void add_verdict(const MethodComparison2& comparison, double beyond, MethodResult& result);

}  // namespace hottel

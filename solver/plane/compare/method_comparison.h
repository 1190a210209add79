// Approximate methods beside the exact one, on one scene: how wrong, and how long.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "geometry/exchange_matrix.h"
#include "solver/compare/method_result.h"
#include "solver/plane/methods/exchange_method.h"
#include "solver/plane/simulation/simulation.h"
#include "solver/radiosity/radiosity_solution.h"

namespace hottel {

// A scene with its exact factors and radiosities, ready to judge methods.
//
//   (1) exact() is over the elements that the surfaces ask for, with visibilities; all methods are held against it
//   (2) where radiosities cannot be solved for, exact_solution() is nothing and why_no_solution() says why; methods are
//       then judged by their factors alone
class MethodComparison2 {
 public:
  // Of the simulation only the scene and the memory allowed matter; its exact factors are shared where it has them by
  // elements and with visibilities. COST: the exact factors and one solution.
  explicit MethodComparison2(const Simulation2& simulation, const StageProgress& progress = {});

  // Runs a method, times it and takes its errors. runs: as in time_repeatedly(). Of repeated runs the last one's matrix
  // and report are kept. Seconds are the method's own where its report has them.
  //
  //   (1) max_radiosity_error is nothing where there is no exact solution; it is infinite, and a note says why, where
  //       the method's matrix has none though there is an exact one
  // Throws RequestError when the method cannot be run on the scene. COST: the runs, and one solution of its matrix.
  MethodResult run(const ExchangeMethod2& method, const std::optional<int>& runs = {}) const;

  const PreparedScene2& prepared() const { return *prepared_; }
  const ExchangeMatrix& exact() const { return exact_->matrix; }  // with visibilities
  const std::optional<RadiositySolution>& exact_solution() const { return exact_solution_; }
  const RadiositySolution& required_solution() const;  // throws RequestError when there is none
  const std::string& why_no_solution() const { return why_no_solution_; }

 private:
  std::optional<RadiositySolution> solve(const ExchangeMatrix& matrix, std::string& why_not) const;

  std::shared_ptr<const PreparedScene2> prepared_;
  std::shared_ptr<const ComputedFactors2> exact_;
  std::string why_no_solution_;
  std::optional<RadiositySolution> exact_solution_;
};

// Adds the verdict in words to the notes of a result whose factors were read from a file or came from a command; does
// nothing to others. REQUIRES a result of this comparison, with its matrix. beyond: as in VerdictOptions.
void add_verdict(const MethodComparison2& comparison, double beyond, MethodResult& result);

}  // namespace hottel

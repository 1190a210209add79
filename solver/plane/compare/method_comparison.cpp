#include "solver/plane/compare/method_comparison.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "geometry/plane/arrangement/prepared_scene.h"
#include "kernel/support/failure.h"
#include "kernel/support/stopwatch.h"
#include "solver/compare/timing.h"
#include "solver/plane/compare/verdict.h"
#include "solver/radiosity/radiosity.h"

namespace hottel {

MethodComparison2::MethodComparison2(const Simulation2& simulation, const StageProgress& progress) {
  const Simulation2 by_elements = simulation.with_request(
      {.granularity = Granularity::kElement, .wants_visibility = true, .memory = simulation.request().memory});
  prepared_ = by_elements.prepared(progress);
  exact_ = by_elements.factors(progress);
  exact_solution_ = solve(exact(), why_no_solution_);
}

const RadiositySolution& MethodComparison2::required_solution() const {
  if (!exact_solution_) throw RequestError("radiosities cannot be compared: " + why_no_solution_);
  return *exact_solution_;
}

std::optional<RadiositySolution> MethodComparison2::solve(const ExchangeMatrix& matrix, std::string& why_not) const {
  try {
    return solve_radiosity(matrix, prepared().scene.materials, prepared().scene.sky_emission);
  } catch (const RequestError& error) {
    why_not = error.what();
    return std::nullopt;
  }
}

MethodResult MethodComparison2::run(const ExchangeMethod2& method, const std::optional<int>& runs) const {
  MethodResult result;
  result.info = method.info();
  result.timing = time_repeatedly(
      [&] {
        result.report = {};
        Stopwatch watch;
        result.matrix = method.compute(prepared(), {.granularity = Granularity::kElement, .wants_visibility = false},
                                       result.report);
        const double seconds = watch.lap();
        return result.report.seconds.value_or(seconds);
      },
      runs);
  result.notes = result.report.notes;
  result.errors = matrix_errors(result.matrix, exact());
  result.declared_error = method.declared_error(prepared());
  if (!exact_solution_) return result;

  std::string why_not;
  result.solution = solve(result.matrix, why_not);
  result.max_radiosity_error = result.solution ? max_radiosity_error(*result.solution, *exact_solution_)
                                               : std::numeric_limits<double>::infinity();
  if (!result.solution) result.notes.push_back(why_not);
  return result;
}

void add_verdict(const MethodComparison2& comparison, double beyond, MethodResult& result) {
  if (!result.report.written) return;
  const Verdict verdict = judge(comparison.prepared(), comparison.exact(), result.matrix,
                                {.beyond = beyond, .written = *result.report.written});
  std::ranges::move(verdict_sentences(verdict, comparison.exact()), std::back_inserter(result.notes));
}

}  // namespace hottel

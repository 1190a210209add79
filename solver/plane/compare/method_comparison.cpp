#include "solver/plane/compare/method_comparison.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "geometry/plane/exchange/exchange.h"
#include "kernel/support/failure.h"
#include "kernel/support/stopwatch.h"
#include "solver/plane/compare/verdict.h"
#include "solver/radiosity/radiosity.h"

namespace hottel {

MethodComparison2::MethodComparison2(const PreparedScene2& prepared)
    : prepared_(prepared),
      exact_(exact_exchange(prepared, {.granularity = Granularity::kElement})),
      exact_solution_(solve(exact_, why_no_solution_)) {}

const RadiositySolution& MethodComparison2::required_solution() const {
  if (!exact_solution_) throw RequestError("radiosities cannot be compared: " + why_no_solution_);
  return *exact_solution_;
}

std::optional<RadiositySolution> MethodComparison2::solve(const ExchangeMatrix& matrix, std::string& why_not) const {
  try {
    return solve_radiosity(matrix, prepared_.scene.materials, prepared_.scene.sky_emission);
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
        result.matrix = method.compute(prepared_, result.report);
        const double seconds = watch.lap();
        return result.report.seconds.value_or(seconds);
      },
      runs);
  result.notes = result.report.notes;
  result.errors = matrix_errors(result.matrix, exact_);
  result.declared_error = method.declared_error(prepared_);
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

#include "solver/space/compare/method_comparison.h"

#include <algorithm>
#include <iterator>

#include "solver/space/compare/verdict.h"

namespace hottel {
namespace {

Simulation3 by_elements(const Simulation3& simulation) {
  const FactorsRequest3& asked = simulation.request().factors;
  return simulation.with_request({.factors = {.granularity = Granularity::kElement,
                                              .wants_visibility = true,
                                              .tolerance = asked.tolerance,
                                              .memory = asked.memory}});
}

std::shared_ptr<const ExchangeMatrix> matrix_of(const Simulation3& simulation, const StageProgress& progress) {
  const auto computed = simulation.factors(progress);
  return {computed, &computed->matrix};
}

}  // namespace

MethodComparison3::MethodComparison3(const Simulation3& simulation, const StageProgress& progress)
    : MethodComparison(by_elements(simulation).prepared(progress), matrix_of(by_elements(simulation), progress),
                       simulation.request().factors.tolerance) {}

void add_verdict(const MethodComparison3& comparison, double beyond, MethodResult& result) {
  if (!result.report.written) return;
  const Verdict verdict = judge(comparison.prepared(), comparison.exact(), result.matrix,
                                {.beyond = beyond, .written = *result.report.written});
  std::ranges::move(verdict_sentences(verdict, comparison.exact()), std::back_inserter(result.notes));
}

}  // namespace hottel

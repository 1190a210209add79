#include "solver/plane/compare/method_comparison.h"

#include <algorithm>
#include <iterator>

#include "geometry/plane/arrangement/prepared_scene.h"
#include "solver/plane/compare/verdict.h"

namespace hottel {
namespace {

Simulation2 by_elements(const Simulation2& simulation) {
  return simulation.with_request(
      {.granularity = Granularity::kElement, .wants_visibility = true, .memory = simulation.request().memory});
}

std::shared_ptr<const ExchangeMatrix> matrix_of(const Simulation2& simulation, const StageProgress& progress) {
  const auto computed = simulation.factors(progress);
  return {computed, &computed->matrix};
}

}  // namespace

MethodComparison2::MethodComparison2(const Simulation2& simulation, const StageProgress& progress)
    : MethodComparison(by_elements(simulation).prepared(progress), matrix_of(by_elements(simulation), progress), 0) {}

void add_verdict(const MethodComparison2& comparison, double beyond, MethodResult& result) {
  if (!result.report.written) return;
  const Verdict verdict = judge(comparison.prepared(), comparison.exact(), result.matrix,
                                {.beyond = beyond, .written = *result.report.written});
  std::ranges::move(verdict_sentences(verdict, comparison.exact()), std::back_inserter(result.notes));
}

}  // namespace hottel

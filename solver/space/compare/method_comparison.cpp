#include "solver/space/compare/method_comparison.h"

#include <algorithm>
#include <iterator>

#include "kernel/support/stopwatch.h"
#include "solver/space/compare/verdict.h"
#include "solver/space/light/illumination_grid.h"

namespace hottel {
namespace {

ComparisonReference<PreparedScene3> reference_of(const Simulation3& simulation, const StageProgress& progress) {
  const FactorsRequest3& asked = simulation.request().factors;
  const Simulation3 by_elements = simulation.with_request({.factors = {.granularity = Granularity::kElement,
                                                                       .wants_visibility = true,
                                                                       .tolerance = asked.tolerance,
                                                                       .must_be_enclosed = asked.must_be_enclosed,
                                                                       .memory = asked.memory,
                                                                       .store = asked.store}});
  const auto prepared = by_elements.prepared(progress);
  Stopwatch watch;
  const auto computed = by_elements.factors(progress);
  const double seconds = watch.lap();
  return {prepared,        {computed, &computed->matrix}, *by_elements.light_shares(progress),
          asked.tolerance, asked.must_be_enclosed,        seconds};
}

}  // namespace

MethodComparison3::MethodComparison3(const Simulation3& simulation, const StageProgress& progress)
    : MethodComparison(reference_of(simulation, progress)) {}

void add_verdict(const MethodComparison3& comparison, double beyond, MethodResult& result) {
  add_verdict(comparison, beyond, result, VerdictWatch());
}

void add_verdict(const MethodComparison3& comparison, double beyond, MethodResult& result, const VerdictWatch& watch) {
  if (!result.report.written) return;
  const Verdict verdict = judge(comparison.prepared(), comparison.exact(), result.matrix,
                                {.beyond = beyond, .written = *result.report.written}, watch);
  std::ranges::move(verdict_sentences(verdict, comparison.exact()), std::back_inserter(result.notes));
}

IlluminationGrid3 exact_light_on(const MethodComparison3& comparison, const Grid3& grid) {
  return illuminate_points(comparison.prepared(), Granularity::kElement, comparison.required_solution(), grid);
}

}  // namespace hottel

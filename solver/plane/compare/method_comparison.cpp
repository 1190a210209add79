#include "solver/plane/compare/method_comparison.h"

#include <algorithm>
#include <iterator>

#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "kernel/support/stopwatch.h"
#include "solver/plane/compare/verdict.h"
#include "solver/plane/light/illumination_grid.h"

namespace hottel {
namespace {

ComparisonReference<PreparedScene2> reference_of(const Simulation2& simulation, const StageProgress& progress) {
  const Simulation2 by_elements = simulation.with_request({.granularity = Granularity::kElement,
                                                           .wants_visibility = true,
                                                           .memory = simulation.request().memory,
                                                           .store = simulation.request().store});
  const auto prepared = by_elements.prepared(progress);
  Stopwatch watch;
  const auto computed = by_elements.factors(progress);
  const double seconds = watch.lap();
  return {prepared, {computed, &computed->matrix}, *by_elements.light_shares(progress), 0, false, seconds};
}

}  // namespace

MethodComparison2::MethodComparison2(const Simulation2& simulation, const StageProgress& progress)
    : MethodComparison(reference_of(simulation, progress)) {}

void add_verdict(const MethodComparison2& comparison, double beyond, MethodResult& result) {
  add_verdict(comparison, beyond, result, VerdictWatch());
}

void add_verdict(const MethodComparison2& comparison, double beyond, MethodResult& result, const VerdictWatch& watch) {
  if (!result.report.written) return;
  const Verdict verdict = judge(comparison.prepared(), comparison.exact(), result.matrix,
                                {.beyond = beyond, .written = *result.report.written}, watch);
  std::ranges::move(verdict_sentences(verdict, comparison.exact()), std::back_inserter(result.notes));
}

IlluminationGrid2 exact_light_on(const MethodComparison2& comparison, const Grid2& grid) {
  const RadiositySolution& solution = comparison.required_solution();
  const PreparedScene2& prepared = comparison.prepared();
  const ElementTable2& table = *prepared.elements(Granularity::kElement);
  return with_lights(prepared, illuminate_points(prepared, grid, table, sent_out_2(table, solution, prepared.scene)));
}

}  // namespace hottel

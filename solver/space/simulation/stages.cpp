#include "solver/space/simulation/stages.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "geometry/closed_promise.h"
#include "geometry/space/exchange/closed_promise.h"
#include "geometry/space/exchange/exchange.h"
#include "geometry/space/exchange/exchange_rows.h"
#include "geometry/unmeasured_pairs.h"
#include "kernel/support/failure.h"
#include "kernel/support/memory.h"
#include "kernel/support/stopwatch.h"
#include "kernel/support/with_file_context.h"
#include "solver/methods/negative_factors.h"
#include "solver/radiosity/scene_radiosities.h"
#include "solver/space/dividing/estimate.h"
#include "solver/space/light/average_irradiance.h"
#include "solver/space/light/tested_shares.h"
#include "solver/space/scene_memory.h"
#include "solver/space/scene_plan.h"
#include "solver/space/simulation/cached_factors.h"

namespace hottel {
namespace {

// What an approximate method makes of a scene.
ComputedFactors3 factors_by(const ExchangeMethod3& method, const PreparedScene3& prepared,
                            const FactorsRequest3& request, const StageProgress& progress) {
  ComputedFactors3 result;
  MethodReport report;
  try {
    result.matrix = method.compute(
        prepared,
        {.granularity = request.granularity, .wants_visibility = false, .progress = telling("view factors", progress)},
        report);
  } catch (const RequestError& error) {
    throw RequestError(fmt::format("{}: the method {}: {}", prepared.scene.file, method.info().name, error.what()));
  }
  result.report.surfaces = report.counts.surfaces;
  result.report.vertices = report.counts.vertices;
  result.report.elements = report.counts.elements;
  result.report.pairs = report.counts.pairs;
  result.report.max_defect = report.row_defect;
  result.report.seconds = report.counts.seconds;
  result.notes = {method_sentence(method.info(), result.matrix, report)};
  result.notes.insert(result.notes.end(), report.notes.begin(), report.notes.end());
  return result;
}

// What is asked of the factors of cells: their bounds are what averages are for.
ExchangeRequest request_of_cells(const FactorsRequest3& asked, const std::function<void(double)>& progress) {
  return {.granularity = asked.granularity,
          .tolerance = asked.tolerance,
          .proves = true,
          .sky = asked.sky,
          .memory = memory_allowed(asked.memory),
          .progress = progress};
}

ComputedFactors3 computed_factors(const PreparedScene3& prepared, const FactorsRequest3& request,
                                  const StageProgress& progress) {
  const bool tells_elements_apart = request.method && request.method->works_by_elements();
  require_memory(prepared.scene, {.granularity = tells_elements_apart ? Granularity::kElement : request.granularity},
                 request.memory);
  const ExchangeRequest asked{.granularity = request.granularity,
                              .wants_visibility = request.wants_visibility,
                              .wants_measures = request.wants_measures,
                              .tolerance = request.tolerance,
                              .proves = request.must_be_enclosed,
                              .sky = request.sky,
                              .rows = request.rows,
                              .memory = memory_allowed(request.memory)};
  if (request.method) {
    const auto compute = [&] { return factors_by(*request.method, prepared, request, progress); };
    return request.store ? cached_factors_3(*request.store, *request.method, prepared, asked, compute) : compute();
  }
  return with_file_context_of_pairs(prepared.scene.file, [&] {
    ComputedFactors3 result;
    const std::function<void(double)> told = telling("view factors", progress);
    ExchangeRows3 rows(prepared, asked);
    Stopwatch watch;
    std::optional<StoreTable> table;
    if (request.store) table = store_table_3(rows, prepared, asked);
    const std::uint64_t taken = table ? take_kept(*request.store, *table, asked, rows) : 0;
    std::uint64_t kept = 0;
    double seconds = watch.lap();
    if (table)
      rows.hand_on([&](std::span<const PairSum3> pairs, const PairRanges& known) {
        Stopwatch keeping;
        kept += keep_pairs(*request.store, *table, asked, pairs, known);
        seconds += keeping.lap();
      });
    if (request.watch == nullptr) rows.add_all(told);
    const double all = rows.missing();
    while (rows.missing() > 0) {
      const std::vector<std::uint32_t> next = request.watch->next(rows);
      const double begin = 1 - rows.missing() / all, part = static_cast<double>(next.size()) / all;
      request.watch->have_come(rows, rows.add(next, [&](double done) { told(begin + part * done); }));
    }
    if (table) request.store->add(kept, taken);
    result.matrix = rows.matrix(&result.report);
    if (table) result.report.seconds["store"] = seconds;
    if (request.must_be_enclosed) require_enclosed_3(result.matrix, request.tolerance);
    return result;
  });
}

// Whether lights are called and shine alike but for their power: their shares, and what is said of them, are the same.
bool are_lit_alike(const Scene3& a, const Scene3& b) {
  if (beams_of(a.lights) != beams_of(b.lights)) return false;
  for (std::size_t k = 0; k < a.lights.size(); ++k)
    if (!is_lit_alike_3(a.lights[k], a.light_places[k], b.lights[k], b.light_places[k])) return false;
  return true;
}

}  // namespace

bool is_same_shape(const Scene3& a, const Scene3& b) {
  return a.file == b.file && a.unit == b.unit && a.polygons == b.polygons && a.masks == b.masks &&
         a.groups == b.groups && a.bases == b.bases &&
         std::ranges::equal(a.surfaces, b.surfaces, &Surface::is_alike_undivided) &&
         std::ranges::equal(a.materials, b.materials, {}, &Material::name, &Material::name);
}

bool is_divided_alike(const Scene3& a, const Scene3& b) {
  return std::ranges::equal(a.surfaces, b.surfaces, &Surface::is_divided_alike);
}

bool operator==(const ArrangementInput3& a, const ArrangementInput3& b) {
  return a.scene == b.scene ||
         (is_same_shape(*a.scene, *b.scene) && are_alike_as_before(a.scene->materials, b.scene->materials));
}

PreparedScene3 make_arrangement(const ArrangementInput3& input, const StageProgress&) { return prepare(*input.scene); }

PreparedScene3 make_prepared(const PreparedInput3& input, const StageProgress& progress) {
  return input.arrangement->get(progress)->under(*input.scene);
}

Plan make_plan(const PlanInput3& input, const StageProgress& progress) {
  return plan_scene(*input.prepared->get(progress), input.request, input.sky);
}

bool operator==(const FactorsInput3& a, const FactorsInput3& b) {
  return a.arrangement == b.arrangement && a.request == b.request && is_divided_alike(*a.scene, *b.scene);
}

ComputedFactors3 make_factors(const FactorsInput3& input, const StageProgress& progress) {
  const auto prepared = input.prepared->get(progress);
  if (input.measured) {
    try {
      return *input.measured->get(progress);
    } catch (const InputError&) {  // that scene was refused
    }
  }
  return computed_factors(*prepared, input.request, progress);
}

std::vector<ElementPair> make_hidden(const HiddenInput3& input, const StageProgress& progress) {
  const auto prepared = input.prepared->get(progress);
  const auto factors = input.factors->get(progress);
  return with_file_context(prepared->scene.file,
                           [&] { return hidden_pairs(*prepared, input.granularity, factors->matrix, input.rows); });
}

bool operator==(const LitInput3& a, const LitInput3& b) {
  return a.arrangement == b.arrangement && a.granularity == b.granularity && is_divided_alike(*a.scene, *b.scene);
}

LitElements3 make_lit(const LitInput3& input, const StageProgress& progress) {
  return LitElements3(input.prepared->get(progress), input.granularity);
}

bool operator==(const LightSharesInput3& a, const LightSharesInput3& b) {
  return a.lit == b.lit && a.test == b.test && are_lit_alike(*a.scene, *b.scene);
}

std::vector<LightShares> make_shares(const LightSharesInput3& input, const StageProgress& progress) {
  if (input.scene->lights.empty()) return {};
  return input.test == LightTest::kExact ? input.lit->get(progress)->shares(*input.scene)
                                         : light_shares(*input.prepared->get(progress), input.granularity, input.test);
}

RadiositySolver make_system(const SystemInput3& input, const StageProgress& progress) {
  require_all(input.asked.rows);
  const auto factors = input.factors->get(progress);
  if (input.asked.method == nullptr) {
    require_closed(*input.scene, factors->matrix);
  } else {  // an error of the method is none of the scene
    if (input.scene->closed) require_closed(*input.prepared->get(progress));
    require_not_negative(factors->matrix, input.scene->file, input.asked.method->info().name);
  }
  return with_file_context(input.scene->file, [&] {
    return RadiositySolver(std::shared_ptr<const ExchangeMatrix>(factors, &factors->matrix),
                           input.reflectivities.values, input.options);
  });
}

RadiositySolution make_radiosities(const RadiositiesInput3& input, const StageProgress& progress) {
  const auto solver = input.system->get(progress);
  const auto shares = input.shares->get(progress);
  return scene_radiosities(*solver, *input.scene, *shares, input.factors->get(progress)->notes,
                           telling("radiosity", progress));
}

DividingEstimate make_dividing(const DividingInput3& input, const StageProgress& progress) {
  const auto radiosities = input.radiosities->get(progress);
  const auto prepared = input.prepared->get(progress);
  const auto factors = input.factors->get(progress);
  const auto shares = input.shares->get(progress);
  return with_file_context(prepared->scene.file, [&] {
    return estimate_dividing({.prepared = *prepared,
                              .solved = {prepared->scene, factors->matrix, *radiosities, *shares},
                              .granularity = input.asked.granularity,
                              .has_exact_factors = input.asked.method == nullptr,
                              .lights = input.test,
                              .progress = telling("dividing", progress)});
  });
}

IlluminationGrid3 make_light(const LightInput3& input, const StageProgress& progress) {
  const auto radiosities = input.radiosities->get(progress);
  const auto prepared = input.prepared->get(progress);
  const auto told = telling("illumination", progress);
  return with_file_context_of_pairs(prepared->scene.file, [&] {
    return input.is_average
               ? average_irradiance(*prepared, *radiosities, *input.grid, request_of_cells(input.asked, told))
               : illuminate_points(*prepared, input.asked.granularity, *radiosities, *input.grid, told);
  });
}

}  // namespace hottel

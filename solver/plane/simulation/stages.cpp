#include "solver/plane/simulation/stages.h"

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <tuple>

#include "geometry/plane/exchange/closed_promise.h"
#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/prepared/element_table.h"
#include "kernel/support/memory.h"
#include "kernel/support/stopwatch.h"
#include "kernel/support/with_file_context.h"
#include "solver/methods/negative_factors.h"
#include "solver/plane/dividing/estimate.h"
#include "solver/plane/light/illumination_grid.h"
#include "solver/plane/light/sent_out.h"
#include "solver/plane/light/tested_shares.h"
#include "solver/plane/scene_memory.h"
#include "solver/plane/scene_plan.h"
#include "solver/plane/simulation/cached_factors.h"
#include "solver/radiosity/scene_radiosities.h"

namespace hottel {
namespace {

// For each material the first that acts as it does.
std::vector<std::size_t> first_alike(const std::vector<Material>& materials) {
  std::map<std::tuple<std::array<Rational, 3>, std::array<Rational, 3>, std::optional<Rational>, bool>, std::size_t>
      first;
  std::vector<std::size_t> result;
  for (const Material& material : materials)
    result.push_back(
        first
            .try_emplace({material.reflectivity.value, material.emission.value,
                          material.has_given_flux() ? material.emissivity : std::nullopt, material.keeps_gains()},
                         result.size())
            .first->second);
  return result;
}

// All of a scene that its undivided arrangement comes from: its shape, its names, and which materials act alike.
bool is_same_shape(const Scene2& a, const Scene2& b) {
  return a.file == b.file && a.unit == b.unit && a.edges == b.edges &&
         std::ranges::equal(a.surfaces, b.surfaces, &Surface::is_alike_undivided) && a.groups == b.groups &&
         a.bases == b.bases && std::ranges::equal(a.materials, b.materials, {}, &Material::name, &Material::name) &&
         first_alike(a.materials) == first_alike(b.materials);
}

IlluminationGrid2 light_of_rows(const LightRows2& rows, const LightInput2& input, const PreparedScene2& prepared,
                                const RadiositySolution& solution) {
  const ElementTable2& table = *prepared.elements(input.granularity);
  return with_lights(prepared, illuminate_points(rows, input.grid, sent_out_2(table, solution, prepared.scene)));
}

}  // namespace

bool operator==(const ArrangementInput2& a, const ArrangementInput2& b) {
  return a.scene == b.scene || is_same_shape(*a.scene, *b.scene);
}

PreparedScene2 make_arrangement(const ArrangementInput2& input, const StageProgress&) { return prepare(*input.scene); }

PreparedScene2 make_divided(const DivisionInput2& input, const StageProgress& progress) {
  return prepare_divided(*input.arrangement->get(progress), *input.scene);
}

PreparedScene2 make_prepared(const PreparedInput2& input, const StageProgress& progress) {
  const auto other = input.arrangement->get(progress);
  return {*input.scene, other->division, other->shared, other->seconds};
}

Plan make_plan(const PlanInput2& input, const StageProgress& progress) {
  return plan_scene(*input.prepared->get(progress), input.request);
}

ComputedFactors2 make_factors(const FactorsInput2& input, const StageProgress& progress) {
  const bool tells_elements_apart = input.method->works_by_elements();
  require_memory(*input.scene,
                 {.granularity = tells_elements_apart ? Granularity::kElement : input.granularity,
                  .pairs_on_disk = input.method->keeps_pairs_on_disk()},
                 input.memory);
  const auto prepared = input.arrangement->get(progress);
  const ExchangeRequest asked{.granularity = input.granularity,
                              .wants_visibility = input.wants_visibility,
                              .wants_measures = input.wants_measures,
                              .always_sweeps = input.everything,
                              .rows = input.rows,
                              .memory = memory_allowed(input.memory),
                              .progress = telling("view factors", progress)};
  return input.store ? cached_factors_2(*input.store, *input.method, *prepared, asked)
                     : factors_by(*input.method, *prepared, asked);
}

RadiositySolver make_system(const SystemInput2& input, const StageProgress& progress) {
  require_all(input.rows);
  const auto factors = input.factors->get(progress);
  const std::shared_ptr<const ExchangeMatrix> matrix(factors, &factors->matrix);
  return with_file_context(input.file,
                           [&] { return RadiositySolver(matrix, input.reflectivities.values, input.options); });
}

RadiositySolution make_radiosities(const RadiositiesInput2& input, const StageProgress& progress) {
  const auto factors = input.factors->get(progress);
  const auto prepared = input.prepared->get(progress);
  const Scene2& scene = prepared->scene;
  const ExchangeMatrix& matrix = factors->matrix;
  if (input.closed)
    require_closed(scene, *input.divided->get(progress), memory_allowed(input.memory),
                   telling("view factors", progress));
  if (input.method->info().guarantee != Guarantee::kExact)
    require_not_negative(matrix, scene.file, input.method->info().name);
  const auto shares = input.shares ? input.shares->get(progress) : nullptr;
  return scene_radiosities(*input.system->get(progress), scene,
                           shares ? std::span<const LightShares>(*shares) : std::span<const LightShares>(),
                           factors->report.notes, telling("radiosity", progress));
}

std::vector<LightShares> make_shares(const LightSharesInput2& input, const StageProgress& progress) {
  return light_shares(*input.prepared->get(progress), input.granularity, input.test);
}

DividingEstimate make_dividing(const DividingInput2& input, const StageProgress& progress) {
  const auto radiosities = input.radiosities->get(progress);
  const auto factors = input.factors->get(progress);
  const auto whole = input.whole->get(progress);
  const auto shares = input.shares ? input.shares->get(progress) : nullptr;
  return with_file_context(whole->scene.file, [&] {
    return estimate_dividing(
        {.whole = *whole,
         .solved = {whole->scene, factors->matrix, *radiosities,
                    shares ? std::span<const LightShares>(*shares) : std::span<const LightShares>()},
         .has_exact_factors = input.method->info().guarantee == Guarantee::kExact,
         .lights = input.test,
         .memory = memory_allowed(input.memory),
         .progress = telling("dividing", progress)});
  });
}

LightRows2 make_rows(const RowsInput2& input, const StageProgress& progress) {
  const auto prepared = input.arrangement->get(progress);
  return with_file_context(prepared->scene.file, [&] {
    return LightRows2(*prepared, input.grid, *prepared->elements(input.granularity), Blacks2::kLeftOut,
                      memory_allowed(input.memory), telling("illumination", progress));
  });
}

SolvedLight2 make_light(const LightInput2& input, const StageProgress& progress) {
  const auto radiosities = input.radiosities->get(progress);
  const auto prepared = input.prepared->get(progress);
  const auto rows = input.rows ? input.rows->get(progress) : nullptr;
  Stopwatch watch;
  SolvedLight2 light = with_file_context(prepared->scene.file, [&]() -> SolvedLight2 {
    if (rows) return {light_of_rows(*rows, input, *prepared, *radiosities)};
    return illuminate(input.kind, *prepared, input.grid, input.granularity, *radiosities,
                      telling("illumination", progress));
  });
  light.seconds = watch.lap();
  return light;
}

Findings2 make_lost_light(const LostLightInput2& input, const StageProgress& progress) {
  const auto prepared = input.prepared->get(progress);
  return lost_light_warnings(*prepared, input.factors->get(progress)->matrix);
}

SceneCheck2 make_check(const CheckInput2& input, const StageProgress& progress) {
  return check_scene(*input.scene, {.prepared = [&] { return input.whole->get(progress); },
                                    .factors =
                                        [&] {
                                          const auto factors = input.exact_factors->get(progress);
                                          return std::shared_ptr<const ExchangeMatrix>(factors, &factors->matrix);
                                        },
                                    .lights = [&] { return *input.shares->get(progress); },
                                    .progress = telling("check", progress)});
}

}  // namespace hottel

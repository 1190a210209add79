#include "solver/space/simulation/queries.h"

#include "geometry/name.h"
#include "kernel/support/failure.h"
#include "solver/space/check/scene_check.h"
#include "solver/space/simulation/simulation.h"

namespace hottel {
namespace {

// The row of an element by name.
std::uint32_t row_of(const ExchangeMatrix& matrix, const std::string& element) {
  const std::uint32_t row = require_element(matrix, element);
  if (row == matrix.sky() || !matrix.has_row(row))
    throw UsageError(quoted_name(element) + " has no row: it is the sky, or has no material or no area");
  return row;
}

}  // namespace

KnownFactor3 view_factor(const Simulation3& simulation, const std::string& from, const std::string& to) {
  const auto factors = simulation.factors();
  const ExchangeMatrix& matrix = factors->matrix;
  const std::uint32_t row = row_of(matrix, from), column = require_element(matrix, to);
  require_chosen(simulation.request().factors.rows, matrix, row);
  const auto entries = matrix.row(row);
  for (std::size_t k = 0; k < entries.size(); ++k)
    if (entries[k].to == column) return {entries[k].factor.value, matrix.bounds(row, k), matrix.guarantee(row, k)};
  if (simulation.request().factors.method) return {0, {0, 1}, Guarantee::kEstimated};
  return {};
}

ElementRadiosity radiosity_of(const Simulation3& simulation, const std::string& element, std::size_t channel) {
  const auto factors = simulation.factors();
  const std::uint32_t row = row_of(factors->matrix, element);
  const auto solution = simulation.radiosities();
  HOTTEL_REQUIRE(channel < solution->channels.size());
  return solution->channels[channel].elements[row];
}

SceneCheck3 scene_check(const Simulation3& simulation, const StageProgress& progress) {
  return check_scene(simulation.scene(), {.prepared = [&] { return simulation.prepared(progress); },
                                          .factors = [&]() -> std::shared_ptr<const ExchangeMatrix> {
                                            const auto computed = simulation.factors(progress);
                                            return {computed, &computed->matrix};
                                          },
                                          .lights = [&] { return *simulation.light_shares(progress); }});
}

}  // namespace hottel

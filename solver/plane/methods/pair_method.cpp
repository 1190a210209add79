#include "solver/plane/methods/pair_method.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/exchange/unobstructed.h"
#include "kernel/doubles.h"
#include "solver/plane/methods/open_space.h"

namespace hottel {
namespace {

constexpr double kNothing = std::numeric_limits<double>::infinity();

}  // namespace

ExchangeMatrix PairMethod2::compute_elements(const PreparedScene2& prepared,
                                             const std::function<void(double)>& progress, MethodReport& report) const {
  const ElementGeometry2 geometry(prepared);
  return matrix_of_pairs({.elements = geometry.table().elements(),
                          .has_row = [&geometry](std::uint32_t i) { return geometry.has_row(i); },
                          .is_open = borders_open_space(prepared.arrangement, geometry.table())},
                         pairs(prepared, geometry), progress, report);
}

ExchangeMethod2::FactorsOfPairs PairMethod2::factors_of_pairs(const PreparedScene2& prepared) const {
  const auto geometry = std::make_shared<const ElementGeometry2>(prepared);
  return one_way(pairs(prepared, *geometry), geometry);
}

double PairMethod2::error_of_free_runs(const Vertices2&, const ElementGeometry2&, const ElementRun2&,
                                       const ElementRun2&) const {
  return kNothing;
}

double PairMethod2::error_of_free_pair(const Vertices2& vertices, const ElementGeometry2& geometry, std::uint32_t from,
                                       std::uint32_t to) const {
  for (const std::uint32_t element : {from, to})
    if (!geometry.is_whole(element)) return kNothing;
  double error = 0;
  for (const ElementRun2& a : geometry.runs(from))
    for (const ElementRun2& b : geometry.runs(to))
      if (face_each_other(vertices, a.ends, b.ends))
        error += a.share * b.length * error_of_free_runs(vertices, geometry, a, b);
  return error;
}

ExchangeMethod2::ClaimedErrors PairMethod2::claimed_errors(const PreparedScene2& prepared) const {
  struct Known {
    ElementGeometry2 geometry;
    ExchangeMatrix exact;
  };
  const auto known = std::make_shared<const Known>(
      Known{ElementGeometry2(prepared), exact_exchange(prepared, {.granularity = Granularity::kElement})});
  const auto of_pair = [this, known, &vertices = prepared.arrangement.vertices()](std::uint32_t from,
                                                                                  std::uint32_t to) {
    const auto entry = known->exact.row(from).find(to);
    if (!entry) return 0.0;
    if (entry->visibility < 1 && !claims_hidden_pairs()) return kNothing;
    return error_of_free_pair(vertices, known->geometry, from, to);
  };
  return [of_pair, known, is_open = borders_open_space(prepared.arrangement, known->geometry.table())](
             std::uint32_t from, std::uint32_t to) {
    if (to != known->geometry.table().sky()) return of_pair(from, to);
    if (!is_open[from]) return 0.0;
    // What the sky gets is off by no more than all the others together, and by the roundings of their sum and its rest.
    double error = 0;
    for (std::uint32_t other = 0; other < known->geometry.count(); ++other)
      if (const double of_other = of_pair(from, other); of_other > 0) error += of_other + 2 * kUnitRoundoff;
    return error;
  };
}

std::optional<double> PairMethod2::declared_error(const PreparedScene2& prepared) const {
  const ElementGeometry2 geometry(prepared);
  const Vertices2& vertices = prepared.arrangement.vertices();
  // Most scenes have walls that meet, of which nothing can be claimed: then no exact factors are needed.
  for (std::uint32_t i = 0; i < geometry.count(); ++i)
    for (std::uint32_t j = 0; j < geometry.count(); ++j)
      if (geometry.has_row(i) && !std::isfinite(error_of_free_pair(vertices, geometry, i, j))) return std::nullopt;
  const ClaimedErrors claimed = claimed_errors(prepared);
  double largest = 0;
  for (std::uint32_t i = 0; i < geometry.count(); ++i)
    for (std::uint32_t j = 0; j <= geometry.table().sky(); ++j)
      if (geometry.has_row(i)) largest = std::max(largest, claimed(i, j));
  return std::isfinite(largest) ? std::optional(largest) : std::nullopt;
}

}  // namespace hottel

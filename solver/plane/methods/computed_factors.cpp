#include "solver/plane/methods/computed_factors.h"

#include <fmt/format.h>

#include <algorithm>

#include "kernel/support/failure.h"
#include "kernel/support/stopwatch.h"
#include "solver/plane/methods/coarsened.h"

namespace hottel {

ComputedFactors2 factors_by(const ExchangeMethod2& method, const PreparedScene2& prepared, Granularity granularity) {
  ComputedFactors2 result;
  Stopwatch watch;
  try {
    result.matrix = method.compute(prepared, result.report);
  } catch (const RequestError& error) {
    throw RequestError(fmt::format("{}: the method {}: {}", prepared.scene.file, method.info().name, error.what()));
  }
  if (granularity == Granularity::kGroup ||
      (granularity == Granularity::kFace &&
       std::any_of(prepared.division.begin(), prepared.division.end(), [](std::uint32_t parts) { return parts > 1; })))
    result.matrix = coarsened(result.matrix, prepared, granularity);
  const double seconds = watch.lap();
  result.counts.surfaces = prepared.scene.surfaces.size();
  result.counts.vertices = prepared.arrangement.vertices().size();
  result.counts.pieces = prepared.arrangement.pieces().size();
  result.counts.elements = result.matrix.size();
  result.counts.pairs = result.matrix.entry_count();
  result.counts.seconds["prepare"] = prepared.seconds;
  result.counts.seconds["factors"] = result.report.seconds.value_or(seconds);
  result.report.notes.insert(result.report.notes.begin(),
                             fmt::format("view factors by {}: {}, rows sum to 1 within {:.2g}", method.info().name,
                                         to_string(result.matrix.guarantee()), result.report.row_defect));
  return result;
}

void require_not_negative(const ExchangeMatrix& matrix, const PreparedScene2& prepared, const ExchangeMethod2& method) {
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    for (const FactorEntry& entry : matrix.row(i))
      if (entry.factor.value < 0)
        throw RequestError(fmt::format("{}: the method {}: a factor of '{}' is negative ({}): nothing can be solved",
                                       prepared.scene.file, method.info().name, matrix.elements()[i].name,
                                       shortest(entry.factor.value)));
}

}  // namespace hottel

#include "solver/plane/methods/exchange_method.h"

#include <algorithm>

#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "kernel/support/stopwatch.h"
#include "solver/methods/coarsened.h"

namespace hottel {

ExchangeMatrix ElementMethod2::compute(const PreparedScene2& prepared, const ExchangeRequest& request,
                                       MethodReport& report) const {
  Stopwatch watch;
  ExchangeMatrix matrix = compute_elements(prepared, request.progress, report);
  const bool is_divided = is_cut(prepared.division);
  if (request.granularity == Granularity::kGroup || (request.granularity == Granularity::kFace && is_divided))
    matrix = coarsened(matrix, prepared.scene,
                       prepare(prepared.scene, Divided2::kNo).elements(request.granularity)->elements(),
                       request.granularity);
  const double seconds = watch.lap();
  ExchangeReport& counts = report.counts;
  counts.surfaces = prepared.scene.surfaces.size();
  counts.vertices = prepared.arrangement.vertices().size();
  counts.pieces = prepared.arrangement.pieces().size();
  counts.elements = matrix.size();
  counts.pairs = matrix.entry_count();
  counts.seconds["prepare"] = prepared.seconds;
  counts.seconds["factors"] = report.seconds.value_or(seconds);
  return matrix;
}

}  // namespace hottel

#include "solver/space/methods/exchange_method.h"

#include <algorithm>

#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "kernel/support/stopwatch.h"
#include "solver/methods/coarsened.h"

namespace hottel {

ExchangeMatrix ElementMethod3::compute(const PreparedScene3& prepared, const ExchangeRequest& request,
                                       MethodReport& report) const {
  Stopwatch watch;
  ExchangeMatrix matrix = compute_elements(prepared, request.progress, report);
  const bool is_divided = std::ranges::any_of(prepared.scene.surfaces, &Surface::is_divided);
  if (request.granularity == Granularity::kGroup || (request.granularity == Granularity::kFace && is_divided))
    matrix = coarsened(matrix, prepared.scene, prepared.elements(request.granularity)->elements(), request.granularity);
  const double seconds = watch.lap();
  ExchangeReport& counts = report.counts;
  counts.surfaces = prepared.scene.surfaces.size();
  counts.vertices = prepared.occluders().vertices().size();
  counts.pieces = prepared.occluders().size();
  counts.elements = matrix.size();
  counts.pairs = matrix.entry_count();
  counts.seconds["prepare"] = prepared.seconds;
  counts.seconds["factors"] = report.seconds.value_or(seconds);
  return matrix;
}

}  // namespace hottel

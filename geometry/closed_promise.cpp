#include "geometry/closed_promise.h"

#include <fmt/format.h>

#include "kernel/rational.h"
#include "kernel/support/failure.h"

namespace hottel {

void refuse_promise(const SceneTable& scene, const Element& element, std::optional<double> factor) {
  const Surface& surface = scene.surfaces[element.surface];
  throw RequestError(fmt::format(
      "{}: the scene promises to be closed, but the front of '{}' sees the sky{}; `hottel check` tells where it is "
      "open",
      place_of(scene, surface).text(), element.name, factor ? fmt::format(" (F = {})", shortest(*factor)) : ""));
}

namespace {

// Looks at some of the rows.
void require_closed(const SceneTable& scene, const ExchangeMatrix& matrix, const RowRange& rows) {
  for (std::uint32_t i = rows.first; i < rows.end; ++i) {
    const Element& element = matrix.elements()[i];
    if (element.is_back || !matrix.has_row(i)) continue;
    const Rounded sky = matrix.factor(i, matrix.sky());
    if (sky.value != 0 || sky.side != 0) refuse_promise(scene, element, sky.value);
  }
}

}  // namespace

void require_closed(const SceneTable& scene, const ExchangeMatrix& matrix) {
  if (scene.closed) require_closed(scene, matrix, {0, matrix.size()});
}

void require_closed(const SceneTable& scene, RowRanges& rows) {
  if (!scene.closed) return;
  for (std::size_t k = 0; k < rows.count(); ++k) {
    const RowRange range = rows.load(k);
    require_closed(scene, rows.matrix(), range);
  }
}

}  // namespace hottel
